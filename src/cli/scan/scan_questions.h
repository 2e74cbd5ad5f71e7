/* scan_questions.h - finds the attributes that the machine file needs before programs can be read. */
#ifndef FIVECHECK_CLI_SCAN_SCAN_QUESTIONS_H
#define FIVECHECK_CLI_SCAN_SCAN_QUESTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "base/callbacks.h"
#include "base/diag.h"
#include "base/strbuf.h"
#include "gcode/dialect.h"

struct scan_questions;

/*
 * max_blocks: of loops and subprograms, as in read_options.h; 0: a number that takes a few seconds. `opened` is
 * borrowed, and called for each file of a subprogram, also repeatedly.
 */
struct scan_questions *scan_questions_new(const struct dialect *dialect, int max_blocks,
					  const struct file_opened *opened);
void scan_questions_free(struct scan_questions *questions);

/*
 * Reads the program repeatedly: each time it stops at a question, the question is kept and an arbitrary answer is used.
 * Every axis exists, and so do all tools and offsets. False: it stops at an error that is not a question, which is
 * reported, or the file cannot be read.
 */
bool scan_questions_read(struct scan_questions *questions, FILE *in, const char *name, struct diag *diag);

/* The configuration with all answers so far. */
const struct gcode_config *scan_questions_config(const struct scan_questions *questions);

/* Appends a line for each question: the attribute of the machine file, and the first block that needs it. */
void scan_questions_add(struct strbuf *out, const struct scan_questions *questions);

#endif
