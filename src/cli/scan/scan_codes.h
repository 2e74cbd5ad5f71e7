/* scan_codes.h - counts the codes and words of programs, and lists what fivecheck does with them. */
#ifndef FIVECHECK_CLI_SCAN_SCAN_CODES_H
#define FIVECHECK_CLI_SCAN_SCAN_CODES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "base/strbuf.h"
#include "gcode/dialect.h"

struct scan_code {
	char letter;	/* G or M; 0: a word of the dialect */
	int number;	/* as in struct code; of a word, its place in the sets */
	const struct code_word *word;
	long times;
	size_t programs;	/* number of programs that contain it */
	size_t last_program;	/* the number of the last one, from 1 */
};

struct scan_codes {
	const struct dialect *dialect;
	struct scan_code *items;
	size_t count, capacity;
	size_t programs;	/* examined */
};

void scan_codes_release(struct scan_codes *codes);

/* Collects the codes of a program's lines, without interpreting them; comments and computed numbers are left out. */
void scan_codes_read(struct scan_codes *codes, FILE *in);

/* Appends a row for each code: code, times, programs, state and description, tab separated, with a header. */
void scan_codes_add(struct strbuf *out, struct scan_codes *codes);

#endif
