#include "gcode/text/pipe_read.h"

#include <errno.h>
#include <poll.h>
#include <unistd.h>

/* The number of bytes in the stream's own buffer, left there by earlier reads from the stream. */
static size_t buffered(const FILE *in)
{
#ifdef __GLIBC__
	return (size_t)(in->_IO_read_end - in->_IO_read_ptr);
#else
	(void)in;
	return 0;
#endif
}

/* Waits for input, the end of the input, or a fault. False: `waiting` said stop. */
static bool wait_for_input(int file, const struct cancel *waiting)
{
	struct pollfd input = {.fd = file, .events = POLLIN};
	int ready;

	while (waiting && ((ready = poll(&input, 1, PIPE_ASK_MS)) == 0 || (ready < 0 && errno == EINTR)))
		if (cancel_asked(waiting))
			return false;
	return true;
}

ssize_t pipe_read(FILE *in, const struct cancel *waiting, char *bytes, size_t most, bool *stopped)
{
	const size_t first = buffered(in);
	ssize_t got;

	if (first > 0)
		return (ssize_t)fread(bytes, 1, first < most ? first : most, in);
	do {
		if (!wait_for_input(fileno(in), waiting)) {
			*stopped = true;
			return 0;
		}
		got = read(fileno(in), bytes, most);
	} while (got < 0 && errno == EINTR && waiting);
	return got;
}
