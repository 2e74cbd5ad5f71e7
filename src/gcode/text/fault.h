/* fault.h - reports the faults of a block, with the text of the line for the caret. */
#ifndef FIVECHECK_GCODE_TEXT_FAULT_H
#define FIVECHECK_GCODE_TEXT_FAULT_H

#include <stdbool.h>

#include "base/diag.h"

/* A line of the program, and the receiver of messages about it. Borrows everything. */
struct line_place {
	struct diag *diag;
	const char *file;
	long line;
	const char *text;	/* of the line, without its line end */
};

/* The first byte of the line that is no blank; it may be the terminating NUL. */
static inline const char *line_start(const struct line_place *at)
{
	const char *text = at->text;

	while (*text == ' ' || *text == '\t')
		text++;
	return text;
}

/*
 * Reports an error at a column (from 1) of the line. The value is false, so that a check can end in
 * `return fault(...)`. It is a macro, so that compilers and analysers see that the value is always false.
 */
#define fault(...) (fault_report(__VA_ARGS__), false)
void fault_report(const struct line_place *at, int column, const char *format, ...)
	__attribute__((format(printf, 3, 4)));

/* Reports a warning. */
void caution(const struct line_place *at, int column, const char *format, ...) __attribute__((format(printf, 3, 4)));

/*
 * The place of an element of the machine file or the setup, for faults of these files that are found only while a
 * program is read. If the element has no file, it is `at`.
 */
struct line_place fault_place(const struct line_place *at, struct srcloc element);

/* The place in the line, for messages that are reported in another way. */
struct srcloc line_loc(const struct line_place *at, int column);

#endif
