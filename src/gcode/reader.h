/* reader.h - the lines of a program, streamed from a file or a pipe in bounded memory. */
#ifndef FIVECHECK_GCODE_READER_H
#define FIVECHECK_GCODE_READER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* A longer line is no NC block; LinuxCNC takes 255 bytes. */
#define LINE_LENGTH_MAX 65536

enum reader_status {
	READER_LINE,
	READER_END,
	READER_TOO_LONG,
	READER_NUL_BYTE,
	READER_UTF16,
	READER_MIXED_ENDS,	/* carriage returns that sometimes end a line and sometimes do not */
	READER_FAILED	/* the file could not be read; errno says why */
};

enum line_end { LINE_END_UNKNOWN, LINE_END_LF, LINE_END_CR };

struct line_reader {
	FILE *in;	/* borrowed */
	char *buffer;	/* owned */
	size_t begin, end;	/* what is read and not handed out yet */
	bool at_end;
	enum line_end style;	/* of the first line; the rest must agree */
	long line;	/* number of the line handed out last, from 1 */
};

void reader_init(struct line_reader *reader, FILE *in);
/* Frees the storage; the line number remains. */
void reader_release(struct line_reader *reader);

/*
 * The next line, without its end (LF, CR LF or CR) and ended by a NUL; it
 * lives until the next call. A UTF-8 byte order mark is skipped. With a fault
 * of one line, reader->line is that line, and for READER_NUL_BYTE and
 * READER_MIXED_ENDS *text is what precedes the faulty byte.
 */
enum reader_status reader_next(struct line_reader *reader, const char **text);

#endif
