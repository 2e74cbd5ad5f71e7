/* output.h - the destination of a report: standard output, or a file that gets its name only when it is complete. */
#ifndef FIVECHECK_REPORT_OUTPUT_H
#define FIVECHECK_REPORT_OUTPUT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "base/diag.h"
#include "base/strbuf.h"

/* All zero is closed. */
struct output {
	FILE *file;
	const char *name;	/* for messages; borrowed */
	char *target;	/* the file that output_commit replaces; NULL: `file` is written in place */
	char *temporary;	/* name of the new file until then; NULL: it has no name yet */
	char *buffer;	/* of `file`, owned; NULL: the library's own */
	int error;	/* errno of the first write that failed; 0: none */
};

/*
 * Opens standard output (path NULL) or a file; the path is borrowed. A regular file is not changed until output_commit
 * replaces it; a pipe, a device and the like are written directly. False: reported.
 */
bool output_open(struct output *out, const char *path, struct diag *diag);

/* Writes bytes. False once any write has failed; output_commit reports the failure. */
bool output_write(struct output *out, const char *bytes, size_t count);

/* Writes a text and empties it; otherwise like output_write. */
bool output_text(struct output *out, struct strbuf *text);

/* Hands everything written so far to the system. False once any write has failed. */
bool output_flush(struct output *out);

/*
 * Closes the output and gives the new file its name. False, reported: something could not be written. A pipe that its
 * reader has closed is not reported.
 */
bool output_commit(struct output *out, struct diag *diag);

/* Closes the output and does not change the named file. Does nothing if the output is closed. */
void output_discard(struct output *out);

/* Prints a text on standard output and empties it. False: reported. */
bool output_print(struct strbuf *text, struct diag *diag);

#endif
