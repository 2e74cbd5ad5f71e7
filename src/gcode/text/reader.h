/* reader.h - the lines of a program, streamed from a file or a pipe in bounded memory. */
#ifndef FIVECHECK_GCODE_TEXT_READER_H
#define FIVECHECK_GCODE_TEXT_READER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "base/callbacks.h"

/* The most bytes of a line. A longer line is no NC block; LinuxCNC takes 255 bytes. */
#define LINE_LENGTH_MAX 65536

enum reader_status {
	READER_LINE,
	READER_END,
	READER_TOO_LONG,
	READER_NUL_BYTE,
	READER_NO_TEXT,	/* a file type of base/file_signature.h */
	READER_MIXED_ENDS,	/* some carriage returns end a line and others do not */
	READER_FAILED,	/* the file could not be read; errno says why */
	READER_STOPPED	/* reader->waiting said stop */
};

/* A reader of a pipe can go back by this number of bytes. */
#define READER_WINDOW ((size_t)4 << 20)

enum line_end { LINE_END_UNKNOWN, LINE_END_LF, LINE_END_CR };

struct reader {
	FILE *in;	/* borrowed */
	bool is_pipe;	/* available bytes are read at once, by pipe_read */
	const struct cancel *waiting;	/* see pipe_read; NULL (the initial value): waits without end */
	char *buffer;	/* owned */
	size_t capacity, keep;	/* bytes of the buffer, and of returned lines that stay in it */
	size_t begin, end;	/* bytes that were read and are not returned yet */
	size_t clear;	/* no byte of [begin, clear) is a CR or a NUL; at or before begin: nothing is known */
	size_t cut;	/* index of the NUL after the last line, */
	char cut_byte;	/* and the byte that it replaced */
	bool at_end, stopped;
	bool open_end;	/* the file ends in the last line, without a line end */
	enum line_end style;	/* of the first line; the others must agree */
	long long base;	/* initial position of the stream; -1: it cannot be repositioned */
	long long origin;	/* of the buffer's first byte, in bytes from base */
	long long start;	/* of the last line, in bytes from base */
	long line;	/* number of the last line, from 1 */
	long furthest;	/* the greatest such number */
};

void reader_init(struct reader *reader, FILE *in);
/* Frees the storage; the line number remains. */
void reader_release(struct reader *reader);

/*
 * Reads the next line. *text is the line without its end (LF, CR LF or CR), terminated by a NUL, and is valid until the
 * next call. A UTF-8 byte order mark and NULs at the start of the input are skipped, and bytes 0x1A at its end. A line
 * of a pipe is returned as soon as its end was read; after a CR, as soon as the next byte was read, too.
 * If a line is faulty, reader->line is its number; for READER_NUL_BYTE and READER_MIXED_ENDS *text is the text before
 * the faulty byte; for READER_NO_TEXT *text is a constant with advice.
 */
enum reader_status reader_next(struct reader *reader, const char **text);

/*
 * The next bytes, without consuming them; they are valid until the next call, and *text is not terminated by a NUL.
 * False: fewer than `least` bytes are in the buffer.
 */
bool reader_peek(const struct reader *reader, size_t least, const char **text);

/* The start of the next line, for reader_seek. */
long long reader_position(const struct reader *reader);

/*
 * Makes the line that starts at `position`, with the number `line`, the next line. False: the input is a pipe and the
 * line has left its window, or the file could not be repositioned; nothing has changed.
 */
bool reader_seek(struct reader *reader, long long position, long line);

/* Where a reader stands before it looks ahead. */
struct reader_mark {
	long long next, start;	/* of the next and of the last line, in bytes from base */
	long line, furthest;	/* the number of the last line, and the greatest one */
};

struct reader_mark reader_mark(const struct reader *reader);

/* Returns to the mark, as if no line had been read since. False, and nothing has changed: see reader_seek. */
bool reader_return(struct reader *reader, const struct reader_mark *mark);

#endif
