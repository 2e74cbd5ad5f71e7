/* sinumerik_functions.h - functions of expressions: SIN(...), TRUNC(...), NOT. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_FUNCTIONS_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_FUNCTIONS_H

#include "gcode/eval/expr.h"

/* Reads the arguments behind the upper-case name and computes it. False: reported. */
bool sinumerik_functions_compute(struct expr *expr, const char *name, int column, double *value);

/* Is this upper-case name that of a function? */
bool sinumerik_functions_is(const char *name);

#endif
