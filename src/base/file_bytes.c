#include "base/file_bytes.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/mem.h"

static bool fault(struct diag *diag, const char *path, const char *what)
{
	diag_error(diag, (struct srcloc){.file = path}, "%s", what);
	return false;
}

static bool fault_errno(struct diag *diag, const char *path, const char *what)
{
	diag_error(diag, (struct srcloc){.file = path}, "%s: %s", what, strerror(errno));
	return false;
}

/* The buffer grows while reading, so that a file that shrinks or grows meanwhile does no harm. */
static bool read_all(struct file_bytes *out, int fd, const char *path, struct diag *diag)
{
	struct file_bytes file = {0};
	size_t capacity = 0;
	ssize_t got;

	do {
		file.bytes = mem_grow(file.bytes, &capacity, file.count + 64 * 1024, 1);
		got = read(fd, file.bytes + file.count, capacity - file.count - 1);
		file.count += got > 0 ? (size_t)got : 0;
	} while ((got > 0 && file.count <= FILE_BYTES_MAX) || (got < 0 && errno == EINTR));
	if (got == 0) {
		file.bytes[file.count] = '\0';
		*out = file;
		return true;
	}
	if (got < 0)
		fault_errno(diag, path, "cannot read");
	else
		fault(diag, path, "larger than 512 MiB");
	free(file.bytes);
	return false;
}

bool file_bytes_read(struct file_bytes *out, const char *path, struct diag *diag)
{
	/* O_NONBLOCK: opening a FIFO must not wait for its writer. */
	int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
	struct stat status;
	bool good = false;

	if (fd < 0)
		return fault_errno(diag, path, "cannot open");
	if (fstat(fd, &status) != 0)
		fault_errno(diag, path, "cannot read");
	else if (!S_ISREG(status.st_mode))
		fault(diag, path, S_ISDIR(status.st_mode) ? "is a directory" : "is not a regular file");
	else
		good = read_all(out, fd, path, diag);
	close(fd);
	return good;
}

void file_bytes_release(struct file_bytes *file)
{
	free(file->bytes);
	*file = (struct file_bytes){0};
}
