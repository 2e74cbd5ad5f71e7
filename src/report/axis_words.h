/* axis_words.h - describes the effect of a positive value of an axis (--check-machine). */
#ifndef FIVECHECK_REPORT_AXIS_WORDS_H
#define FIVECHECK_REPORT_AXIS_WORDS_H

#include "base/strbuf.h"
#include "machine/machine.h"

/*
 * Appends a line for each axis, with all axes at 0: how the bodies that it carries move in the drawing, and how the
 * tool moves relative to the work.
 */
void axis_words_add(struct strbuf *out, const struct machine *machine);

/* Appends the same for one axis, without its name: "the tool moves 10 mm toward +X". */
void axis_words_add_axis(struct strbuf *out, const struct machine *machine, const struct axis *axis);

#endif
