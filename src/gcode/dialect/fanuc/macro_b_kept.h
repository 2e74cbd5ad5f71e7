/* macro_b_kept.h - what variables of the control hold before a program begins, from the machine file. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_KEPT_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_KEPT_H

#include <stdbool.h>

struct interp;

/*
 * The value of #number, which may be vacant. False: the machine file does not tell it, or no number, which was reported
 * at the column; `why`, a sentence without its end, begins the message.
 */
bool macro_b_kept_read(struct interp *interp, int number, int column, const char *why, double *value);

/* Does the machine file tell it? */
bool macro_b_kept_tells(const struct interp *interp, int number);

#endif
