#include "gcode/text/reader.h"

#include <stdlib.h>
#include <string.h>

#include "base/file_signature.h"
#include "base/mem.h"
#include "gcode/text/pipe_read.h"

/* Bytes requested by one read: several of the longest lines, so that an incomplete line is rarely moved. */
#define CHUNK ((size_t)4 * LINE_LENGTH_MAX)

/* Bytes before the current line that stay in the buffer: shorter loops need not read the file again. */
#define FILE_KEEP (CHUNK / 2)

/* Bytes after a line that are searched together for bytes that a line must not have. */
#define AHEAD 4096

#define END_OF_TEXT 0x1A

/* DC1 to DC4, with which controls and tape units switch reader and punch on and off (Fanuc, "Reader/Puncher"). */
static bool switches_device(char byte)
{
	return byte >= 0x11 && byte <= 0x14;
}

static bool ends_text(char byte)
{
	return byte == END_OF_TEXT || switches_device(byte);
}

void reader_init(struct reader *reader, FILE *in)
{
	off_t base = ftello(in);

	*reader = (struct reader){.in = in, .is_pipe = base < 0 && fileno(in) >= 0, .base = base};
	reader->keep = base < 0 ? READER_WINDOW : FILE_KEEP;
	reader->capacity = 2 * reader->keep + CHUNK;
	reader->buffer = mem_alloc(reader->capacity + 1);
}

void reader_release(struct reader *reader)
{
	free(reader->buffer);
	reader->buffer = NULL;
	reader->begin = reader->end = 0;
}

/* Reads this number of bytes, or the available bytes of a pipe; false on a read error. */
static bool read_bytes(struct reader *reader, size_t want)
{
	char *bytes = reader->buffer + reader->end;
	ssize_t came;
	size_t got;

	if (reader->is_pipe) {
		came = pipe_read(reader->in, reader->waiting, bytes, want, &reader->stopped);
		if (came < 0)
			return false;
		reader->end += (size_t)came;
		reader->at_end = came == 0;
		return true;
	}
	got = fread(bytes, 1, want, reader->in);
	reader->end += got;
	if (got < want && ferror(reader->in))
		return false;
	reader->at_end = got < want;
	return true;
}

/* Makes room for a chunk and reads it, or the available bytes of a pipe; false on a read error. */
static bool refill(struct reader *reader)
{
	size_t drop = 0, want;

	if (reader->capacity - reader->end < CHUNK && reader->begin > reader->keep)
		drop = reader->begin - reader->keep;
	memmove(reader->buffer, reader->buffer + drop, reader->end - drop);
	reader->clear -= reader->clear < drop ? reader->clear : drop;
	reader->begin -= drop;
	reader->end -= drop;
	reader->origin += (long long)drop;
	want = reader->capacity - reader->end < CHUNK ? reader->capacity - reader->end : CHUNK;
	if (want > 0 && !read_bytes(reader, want))
		return false;
	/* CP/M ended text with 0x1A, and controls still send this byte after the last block. */
	while (reader->at_end && reader->end > reader->begin && ends_text(reader->buffer[reader->end - 1]))
		reader->end--;
	reader->cut = reader->end;
	return true;
}

/* The first of these bytes in [p, end), or end. */
static const char *find_byte(const char *p, const char *end, char byte)
{
	const char *found = memchr(p, byte, (size_t)(end - p));

	return found ? found : end;
}

/* The first CR or NUL in [p, end), or end. */
static const char *find_odd(const char *p, const char *end)
{
	return find_byte(p, find_byte(p, end, '\r'), '\0');
}

/* The first byte at or after `from` that ends a line or is not allowed, or reader->end. */
static size_t find_break(struct reader *reader, size_t from)
{
	const char *p = reader->buffer + from, *end = reader->buffer + reader->end, *line_end;

	/* If lines end with CR, a search for LF would examine the whole buffer at each line. */
	if (reader->style == LINE_END_LF) {
		line_end = find_byte(p, end, '\n');
		p = find_odd(p, line_end);
		/* After a line without such bytes, the next lines probably have none either. */
		if (p == line_end)
			reader->clear = (size_t)(find_odd(p, end - line_end > AHEAD ? line_end + AHEAD : end) -
						 reader->buffer);
		return (size_t)(p - reader->buffer);
	}
	while (p < end && *p != '\n' && *p != '\r' && *p != '\0')
		p++;
	return (size_t)(p - reader->buffer);
}

/* The start of the text, after the blank leader of a tape (NULs) and the codes that switch a device on. */
static size_t find_text(const struct reader *reader)
{
	size_t text = reader->begin;

	while (text < reader->end && (reader->buffer[text] == '\0' || switches_device(reader->buffer[text])))
		text++;
	return text;
}

/* Skips the bytes before the text, if the buffer can hold them; false on a read error. */
static bool skip_feed(struct reader *reader)
{
	while (find_text(reader) == reader->end && !reader->at_end && reader->end < reader->capacity)
		if (!refill(reader))
			return false;
	/* Only NULs are no program. */
	if (find_text(reader) < reader->end)
		reader->begin = find_text(reader);
	return true;
}

/* Skips the byte order mark of UTF-8. Returns advice if the file is no text, else NULL. */
static const char *check_start(struct reader *reader)
{
	const char *start = reader->buffer + reader->begin;
	const size_t length = reader->end - reader->begin;

	if (length >= 3 && !memcmp(start, "\xef\xbb\xbf", 3))
		reader->begin += 3;
	return file_signature_advice(start, length);
}

/* Takes the line that ends at `at`; *next is the start of the following line. */
static enum reader_status take_break(struct reader *reader, size_t at, size_t *next)
{
	const char *p = reader->buffer + at;
	enum line_end style = LINE_END_LF;

	*next = at + 1;
	if (*p == '\0')
		return READER_NUL_BYTE;
	if (*p == '\r') {
		/* CR CR LF, too: text transfer has put a CR before the LF of a CR LF. */
		size_t returns = at + 1 < reader->end && p[1] == '\r' ? 2 : 1;

		if (at + returns < reader->end && p[returns] == '\n')
			*next = at + returns + 1;
		else
			style = LINE_END_CR;
	}
	if (reader->style == LINE_END_UNKNOWN)
		reader->style = style;
	/* LinuxCNC treats a lone CR as a blank, other controls end the block there: two different programs. */
	return style == reader->style ? READER_LINE : READER_MIXED_ENDS;
}

/* Are more bytes needed to find how the line ends? A CR may be part of a CR CR LF. */
static bool is_open(const struct reader *reader, size_t at)
{
	const char *p = reader->buffer + at;

	if (at - reader->begin > LINE_LENGTH_MAX)
		return false;
	return at == reader->end ||
	       (*p == '\r' && (at + 1 == reader->end || (p[1] == '\r' && at + 2 == reader->end)));
}

/* Finds the end of the current line, which is then in the buffer; false on a read error. */
static bool find_line_end(struct reader *reader, size_t *at)
{
	*at = find_break(reader, reader->begin);
	while (!reader->at_end && is_open(reader, *at)) {
		if (!refill(reader))
			return false;
		*at = find_break(reader, reader->begin);
	}
	return true;
}

/* Fanuc controls send LF CR CR after a block: these CRs are not the ends of further lines. */
static bool skip_returns(struct reader *reader, size_t *at)
{
	while (reader->style == LINE_END_LF && *at == reader->begin && *at < reader->end &&
	       reader->buffer[*at] == '\r' && (*at + 1 == reader->end || reader->buffer[*at + 1] != '\n')) {
		reader->begin++;
		if (!find_line_end(reader, at))
			return false;
	}
	return true;
}

/* The next line begins at reader->begin; its end is not known yet. */
static void begin_line(struct reader *reader)
{
	reader->start = reader_position(reader);
	if (++reader->line > reader->furthest)
		reader->furthest = reader->line;
}

/*
 * Terminates the line, which ends at `at`; the one after it begins at `next`. Returns its text. The next call of
 * reader_next puts the byte back, because the program may jump back to this line.
 */
static const char *cut_line(struct reader *reader, size_t at, size_t next)
{
	const char *text = reader->buffer + reader->begin;

	reader->open_end = at == reader->end;
	reader->cut = at;
	reader->cut_byte = reader->buffer[at];
	reader->buffer[at] = '\0';
	reader->begin = next;
	return text;
}

/* The next line, if it ends with LF in the part of the buffer that is known to have no CR or NUL; else NULL. */
static const char *next_clear_line(struct reader *reader)
{
	const char *begin = reader->buffer + reader->begin, *end = NULL;
	size_t at;

	if (reader->begin < reader->clear)
		end = memchr(begin, '\n', reader->clear - reader->begin);
	if (!end)
		return NULL;
	at = (size_t)(end - reader->buffer);
	begin_line(reader);
	return cut_line(reader, at, at + 1);
}

/* Any line. */
static enum reader_status next_line(struct reader *reader, const char **text)
{
	enum reader_status status = READER_LINE;
	const char *advice = NULL;
	size_t at, next;

	/* The line number is 0 at the start of the file, also after a look ahead that has returned there. */
	if ((reader->line == 0 && !skip_feed(reader)) || !find_line_end(reader, &at) || !skip_returns(reader, &at))
		return READER_FAILED;
	if (reader->stopped)
		return READER_STOPPED;
	if (reader->line == 0) {
		advice = check_start(reader);
		at = find_break(reader, reader->begin);
	}
	if (!advice && at == reader->end && reader->begin == reader->end)
		return READER_END;
	begin_line(reader);
	*text = advice ? advice : reader->buffer + reader->begin;
	if (advice)
		return READER_NO_TEXT;
	if (at - reader->begin > LINE_LENGTH_MAX)
		return READER_TOO_LONG;
	next = at;
	if (at < reader->end)
		status = take_break(reader, at, &next);
	cut_line(reader, at, next);
	return status;
}

enum reader_status reader_next(struct reader *reader, const char **text)
{
	const char *line;

	reader->buffer[reader->cut] = reader->cut_byte;
	reader->cut = reader->end;
	reader->cut_byte = '\0';
	/* Nearly all lines of most files are such lines. */
	line = next_clear_line(reader);
	if (!line)
		return next_line(reader, text);
	*text = line;
	return READER_LINE;
}

bool reader_peek(const struct reader *reader, size_t least, const char **text)
{
	*text = reader->buffer + reader->begin;
	return reader->end - reader->begin >= least;
}

long long reader_position(const struct reader *reader)
{
	return reader->origin + (long long)reader->begin;
}

bool reader_seek(struct reader *reader, long long position, long line)
{
	reader->clear = 0;
	if (position >= reader->origin && position <= reader->origin + (long long)reader->end) {
		reader->begin = (size_t)(position - reader->origin);
		reader->line = line - 1;
		return true;
	}
	if (reader->base < 0 || fseeko(reader->in, (off_t)(reader->base + position), SEEK_SET))
		return false;
	reader->buffer[0] = '\0';
	reader->begin = reader->end = reader->cut = 0;
	reader->cut_byte = '\0';
	reader->at_end = false;
	reader->origin = position;
	reader->line = line - 1;
	return true;
}

struct reader_mark reader_mark(const struct reader *reader)
{
	return (struct reader_mark){reader_position(reader), reader->start, reader->line, reader->furthest};
}

bool reader_return(struct reader *reader, const struct reader_mark *mark)
{
	if (!reader_seek(reader, mark->next, mark->line + 1))
		return false;
	reader->start = mark->start;
	reader->furthest = mark->furthest;
	return true;
}
