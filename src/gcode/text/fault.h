/* fault.h - reports what is wrong with a block, with the block's text below for the caret. */
#ifndef FIVECHECK_GCODE_TEXT_FAULT_H
#define FIVECHECK_GCODE_TEXT_FAULT_H

#include <stdbool.h>

#include "base/diag.h"

/* A line of the program, and where messages about it go. Borrows everything. */
struct line_place {
	struct diag *diag;
	const char *file;
	long line;
	const char *text;	/* as read, without its line end */
};

/* The first byte of the line that is no blank, which may be its NUL. */
static inline const char *line_start(const struct line_place *at)
{
	const char *text = at->text;

	while (*text == ' ' || *text == '\t')
		text++;
	return text;
}

/*
 * Reports an error at a column (from 1) of the line; false, so that a check can end in `return fault(...)`.
 * A macro, so that compilers and analysers see that nothing goes on behind a fault.
 */
#define fault(...) (fault_report(__VA_ARGS__), false)
void fault_report(const struct line_place *at, int column, const char *format, ...)
	__attribute__((format(printf, 3, 4)));

/* Reports a warning. */
void caution(const struct line_place *at, int column, const char *format, ...) __attribute__((format(printf, 3, 4)));

/*
 * The place of an element of the machine file or the setup, for faults that only the reading of a program finds there.
 * Without a file it is `at`.
 */
struct line_place fault_place(const struct line_place *at, struct srcloc element);

/* The place itself, for messages that are reported in another way. */
struct srcloc line_loc(const struct line_place *at, int column);

#endif
