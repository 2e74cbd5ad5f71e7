/* sinumerik_assign.h - R1=5, NAME=5, NAME[1,2]=SET(1,2,3), and DEF. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_ASSIGN_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_ASSIGN_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/* Is this upper-case name an R parameter or a variable of the program? */
bool sinumerik_assign_is_own(const struct interp *interp, const char *name);

/* After the upper-case name: reads indices, '=' and the values, and assigns them. False: reported. */
bool sinumerik_assign(struct interp *interp, struct lexer *lexer, const char *name, int column);

/* After DEF: reads the type, and the variables with their initial values. False: reported. */
bool sinumerik_assign_define(struct interp *interp, struct lexer *lexer);

/* The name of a type, "REAL" and the like, or STRING[20] with its length, else 0. False: reported. */
bool sinumerik_assign_type(struct interp *interp, struct lexer *lexer, enum sinumerik_type *type, int *length);

#endif
