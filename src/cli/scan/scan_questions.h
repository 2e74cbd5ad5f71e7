/* scan_questions.h - what the machine file must answer before programs can be read. */
#ifndef FIVECHECK_CLI_SCAN_SCAN_QUESTIONS_H
#define FIVECHECK_CLI_SCAN_SCAN_QUESTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "gcode/dialect.h"

struct scan_questions;

/* max_blocks: of loops and subprograms, as in read_options.h; 0: what takes a few seconds. */
struct scan_questions *scan_questions_new(const struct dialect *dialect, int max_blocks);
void scan_questions_free(struct scan_questions *questions);

/*
 * Reads the program again and again: each time that it stops at a question, the question is kept and some answer to it
 * is taken. Every axis is there, and so are all tools and offsets. False: it stops at a fault that is no question,
 * which is reported, or the file cannot be read.
 */
bool scan_questions_read(struct scan_questions *questions, FILE *in, const char *name, struct diag *diag);

/* How programs are read with all answers that were taken so far. */
const struct gcode_config *scan_questions_config(const struct scan_questions *questions);

/* Appends a line for each question: what the machine file is to say, and where a program needs it first. */
void scan_questions_add(struct strbuf *out, const struct scan_questions *questions);

#endif
