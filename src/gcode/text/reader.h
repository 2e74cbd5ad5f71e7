/* reader.h - the lines of a program, streamed from a file or a pipe in bounded memory. */
#ifndef FIVECHECK_GCODE_TEXT_READER_H
#define FIVECHECK_GCODE_TEXT_READER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "base/callbacks.h"

/* A longer line is no NC block; LinuxCNC takes 255 bytes. */
#define LINE_LENGTH_MAX 65536

enum reader_status {
	READER_LINE,
	READER_END,
	READER_TOO_LONG,
	READER_NUL_BYTE,
	READER_NO_TEXT,	/* what base/file_signature.h knows */
	READER_MIXED_ENDS,	/* carriage returns that sometimes end a line and sometimes do not */
	READER_FAILED,	/* the file could not be read; errno says why */
	READER_STOPPED	/* reader->waiting said stop */
};

/* A reader of a pipe can go back by this number of bytes. */
#define READER_WINDOW ((size_t)4 << 20)

enum line_end { LINE_END_UNKNOWN, LINE_END_LF, LINE_END_CR };

struct reader {
	FILE *in;	/* borrowed */
	bool is_pipe;	/* what comes is read at once: by pipe_read */
	const struct cancel *waiting;	/* see pipe_read; NULL, as it is at first: waits */
	char *buffer;	/* owned */
	size_t capacity, keep;	/* bytes of the buffer, and of the lines handed out that stay in it */
	size_t begin, end;	/* bytes that were read and not handed out yet */
	size_t clear;	/* no byte of [begin, clear) is a CR or a NUL; at or before begin: nothing is known */
	size_t cut;	/* where the NUL of the last line stands, and the byte that it replaced */
	char cut_byte;
	bool at_end, stopped;
	bool open_end;	/* the last line has no line end: the file stops in it */
	enum line_end style;	/* of the first line; the rest must agree */
	long long base;	/* position of the stream at first; -1: it cannot be repositioned */
	long long origin;	/* of the buffer's first byte, in bytes from base */
	long long start;	/* of the last line, in bytes from base */
	long line;	/* number of the last line, from 1 */
	long furthest;	/* the greatest such number */
};

void reader_init(struct reader *reader, FILE *in);
/* Frees the storage; the line number remains. */
void reader_release(struct reader *reader);

/*
 * The next line, without its end (LF, CR LF or CR) and ended by a NUL; it
 * lives until the next call. Skipped are a UTF-8 byte order mark and NULs at the
 * start of the input, and bytes 0x1A at its end. A line of a pipe is handed out when its end has come; a CR, when
 * what follows it has come, too. With a fault
 * of one line, reader->line is that line, and for READER_NUL_BYTE and
 * READER_MIXED_ENDS *text is what precedes the faulty byte; for READER_NO_TEXT it is advice, which lives on.
 */
enum reader_status reader_next(struct reader *reader, const char **text);

/*
 * The bytes that come next, which stay the next ones; they live until the next call, and *text has no NUL at its end.
 * False: fewer than `least` of them are in the buffer.
 */
bool reader_peek(const struct reader *reader, size_t least, const char **text);

/* Where the next line starts, for reader_seek. */
long long reader_position(const struct reader *reader);

/*
 * Goes to the line that starts at `position` and has the number `line`: it is
 * the next one. False: the input is a pipe, and the line has left its window, or
 * the file could not be repositioned; nothing has changed.
 */
bool reader_seek(struct reader *reader, long long position, long line);

#endif
