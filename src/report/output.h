/* output.h - where a report goes: standard output, or a file that takes its name only when it is complete. */
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
	char *target;	/* the file that is replaced at the end; NULL: `file` is what the user named */
	char *temporary;	/* its name beside it until then; NULL: it has none yet */
	int error;	/* errno of the first write that failed; 0: none */
};

/*
 * Opens standard output (path NULL) or a file (borrowed). An existing regular
 * file stays as it is until output_commit replaces it; what is no regular
 * file, such as a pipe or /dev/null, is written to directly. False: reported.
 */
bool output_open(struct output *out, const char *path, struct diag *diag);

/* Writes the bytes; false once any write has failed. What failed is reported by output_commit. */
bool output_write(struct output *out, const char *bytes, size_t count);

/* The same for a text, which is then empty. */
bool output_text(struct output *out, struct strbuf *text);

/* Hands everything written so far to the system; false once any write has failed. */
bool output_flush(struct output *out);

/*
 * Closes, and puts a file in its place. False if anything could not be
 * written: reported, except for a pipe whose reader has left.
 */
bool output_commit(struct output *out, struct diag *diag);

/* Closes and leaves the named file as it was. Nothing happens if it is closed. */
void output_discard(struct output *out);

/* Prints a text on standard output and empties it. False: reported. */
bool output_print(struct strbuf *text, struct diag *diag);

#endif
