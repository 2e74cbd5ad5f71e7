/* sinumerik_variables.h - variables that DEF and PROC make; each is visible only in its own program. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_VARIABLES_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_VARIABLES_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/*
 * The index of the variable with this upper-case name in the current program, or else of the control; -1: none. For a
 * VAR parameter it is the variable to which the parameter refers.
 */
int sinumerik_variables_find(const struct sinumerik *sinumerik, const char *name);

/* The same, but a VAR parameter itself, and no variables of the control. */
int sinumerik_variables_find_own(const struct sinumerik *sinumerik, const char *name);

/*
 * Makes the variable that `made` describes by name, type, dimensions, size and refers_to; its values are 0 or empty.
 * The current program has none with this name. NULL: there are too many, which was reported at the column.
 */
struct sinumerik_variable *sinumerik_variables_add(struct interp *interp, const struct sinumerik_variable *made,
						   int column);

/* Deletes the variables of deeper levels than this one. */
void sinumerik_variables_leave(struct sinumerik *sinumerik, int level);

/* Writes a number, converted to the variable's type. False: it does not fit, which was reported at the column. */
bool sinumerik_variables_set(struct interp *interp, struct sinumerik_variable *variable, size_t element, double value,
			     int column);

/* Is this value known? False: the machine file does not give it, which was reported at the column. */
bool sinumerik_variables_check(const struct line_place *at, const struct sinumerik_variable *variable, size_t element,
			       int column);

/* The program has assigned this element. */
void sinumerik_variables_mark(struct sinumerik_variable *variable, size_t element);

#endif
