/* sinumerik_variables.h - variables that DEF and PROC make, each seen in its own program only. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_VARIABLES_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_VARIABLES_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/*
 * The variable of the program in hand, or else of the control, with this upper-case name, or -1. A VAR parameter is
 * followed to its end.
 */
int sinumerik_variables_find(const struct sinumerik *sinumerik, const char *name);

/* The same without following a VAR parameter, and without the variables of the control. */
int sinumerik_variables_find_own(const struct sinumerik *sinumerik, const char *name);

/*
 * Makes the variable `made` describes: name, type, dimensions, size, refers_to; its values are 0 or empty. The
 * program in hand has none of this name. NULL: there are too many, which was reported at the column.
 */
struct sinumerik_variable *sinumerik_variables_add(struct interp *interp, const struct sinumerik_variable *made,
						   int column);

/* Ends the variables of deeper levels than this one. */
void sinumerik_variables_leave(struct sinumerik *sinumerik, int level);

/* Writes a number as the variable's type has it. False: it does not fit, which was reported at the column. */
bool sinumerik_variables_set(struct interp *interp, struct sinumerik_variable *variable, size_t element, double value,
			     int column);

/* Is this value known? False: the machine file does not tell it, which was reported at the column. */
bool sinumerik_variables_check(const struct line_place *at, const struct sinumerik_variable *variable, size_t element,
			       int column);

/* The program has given it a value. */
void sinumerik_variables_mark(struct sinumerik_variable *variable, size_t element);

#endif
