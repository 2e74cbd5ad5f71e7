/* scan_codes.h - which codes and words stand in programs, how often, and what becomes of them. */
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
	size_t programs;	/* in which it stands */
	size_t last_program;	/* its number, from 1 */
};

struct scan_codes {
	const struct dialect *dialect;
	struct scan_code *items;
	size_t count, capacity;
	size_t programs;	/* looked at */
};

void scan_codes_release(struct scan_codes *codes);

/* Looks through a program's lines, whatever they mean: comments are left out, and so are numbers that are computed. */
void scan_codes_read(struct scan_codes *codes, FILE *in);

/* Appends a row for each code: code, times, programs, state and what it is, tab separated, with a head. */
void scan_codes_add(struct strbuf *out, struct scan_codes *codes);

#endif
