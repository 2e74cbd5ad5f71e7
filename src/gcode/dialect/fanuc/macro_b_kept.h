/* macro_b_kept.h - the values of the control's variables before a program starts, from the machine file. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_KEPT_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_KEPT_H

#include <stdbool.h>

struct interp;

/*
 * The value of #number, which may be vacant. False: the machine file does not give a number for it, which was reported
 * at the column; the message starts with `why`, a sentence without its end.
 */
bool macro_b_kept_read(struct interp *interp, int number, int column, const char *why, double *value);

/* Does the machine file give the value? */
bool macro_b_kept_tells(const struct interp *interp, int number);

#endif
