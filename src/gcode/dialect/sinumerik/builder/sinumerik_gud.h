/*
 * sinumerik_gud.h - variables of the control that exist before the program: those of the machine's builder and of
 * users (GUD), R parameters and system variables, as far as the machine file gives them.
 */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_BUILDER_SINUMERIK_GUD_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_BUILDER_SINUMERIK_GUD_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/* Makes the variables of the machine file that have a type. False: they contradict each other, which was reported. */
bool sinumerik_gud_make(struct interp *interp);

/* The value of an R parameter at the start of the program; NAN: the machine file does not give it. */
double sinumerik_gud_r(const struct interp *interp, int number);

/*
 * Reports at the column that a name that is read or assigned is not a known variable, and how the machine file makes
 * it. The lexer is after the name. Always false.
 */
bool sinumerik_gud_ask(struct lexer *lexer, const char *name, bool reads, int column);

/*
 * The value of a system variable that the interpreter does not compute, by its name with indices ("$MA_X[1,Y]").
 * False: the machine file does not give it, or it changes while programs run; reported at the column.
 */
bool sinumerik_gud_system(struct interp *interp, const char *name, int column, double *value);

#endif
