#include "gcode/reader.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

/* Several lines of the greatest length, so that the rest of a line is rarely moved. */
#define BUFFER_SIZE ((size_t)4 * LINE_LENGTH_MAX)

void reader_init(struct line_reader *reader, FILE *in)
{
	*reader = (struct line_reader){.in = in, .buffer = mem_alloc(BUFFER_SIZE + 1)};
}

void reader_release(struct line_reader *reader)
{
	free(reader->buffer);
	reader->buffer = NULL;
	reader->begin = reader->end = 0;
}

/* Moves what is left to the front and reads on; false on a read error. */
static bool refill(struct line_reader *reader)
{
	size_t left = reader->end - reader->begin;

	memmove(reader->buffer, reader->buffer + reader->begin, left);
	reader->begin = 0;
	reader->end = left + fread(reader->buffer + left, 1, BUFFER_SIZE - left, reader->in);
	if (reader->end < BUFFER_SIZE) {
		if (ferror(reader->in))
			return false;
		reader->at_end = true;
	}
	return true;
}

/* The first byte at or after `from` that ends a line or must not be there, or reader->end. */
static size_t find_break(const struct line_reader *reader, size_t from)
{
	const char *p = reader->buffer + from, *end = reader->buffer + reader->end;

	for (; p < end; p++) {
		/* Most bytes are settled by the first comparison. */
		if ((unsigned char)*p <= '\r' && (*p == '\n' || *p == '\r' || *p == '\0'))
			break;
	}
	return (size_t)(p - reader->buffer);
}

static enum reader_status check_byte_order_mark(struct line_reader *reader)
{
	const char *start = reader->buffer + reader->begin;
	size_t length = reader->end - reader->begin;

	if (length >= 3 && !memcmp(start, "\xef\xbb\xbf", 3))
		reader->begin += 3;
	if (length >= 2 && (!memcmp(start, "\xff\xfe", 2) || !memcmp(start, "\xfe\xff", 2)))
		return READER_UTF16;
	return READER_LINE;
}

/* Takes the line that breaks at `at`: *next is where the following one starts. */
static enum reader_status take_break(struct line_reader *reader, size_t at, size_t *next)
{
	const char *p = reader->buffer + at;
	enum line_end style = LINE_END_LF;

	*next = at + 1;
	if (*p == '\0')
		return READER_NUL_BYTE;
	if (*p == '\r') {
		if (at + 1 < reader->end && p[1] == '\n')
			*next = at + 2;
		else
			style = LINE_END_CR;
	}
	if (reader->style == LINE_END_UNKNOWN)
		reader->style = style;
	/* LinuxCNC drops a lone CR as a blank, others end the block there: two different programs. */
	return style == reader->style ? READER_LINE : READER_MIXED_ENDS;
}

enum reader_status reader_next(struct line_reader *reader, const char **text)
{
	size_t at = find_break(reader, reader->begin), next;
	enum reader_status status = READER_LINE;

	/* A CR at the very end of what is read may be half of a CR LF. */
	if (!reader->at_end && at + 1 >= reader->end) {
		if (!refill(reader))
			return READER_FAILED;
		if (reader->line == 0)
			status = check_byte_order_mark(reader);
		at = find_break(reader, reader->begin);
	}
	if (status == READER_LINE && at == reader->end && reader->begin == reader->end)
		return READER_END;
	reader->line++;
	*text = reader->buffer + reader->begin;
	if (status != READER_LINE)
		return status;
	if (at - reader->begin > LINE_LENGTH_MAX)
		return READER_TOO_LONG;
	next = at;
	if (at < reader->end)
		status = take_break(reader, at, &next);
	reader->buffer[at] = '\0';
	reader->begin = next;
	return status;
}
