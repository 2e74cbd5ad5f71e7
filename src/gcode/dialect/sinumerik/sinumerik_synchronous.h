/* sinumerik_synchronous.h - synchronous actions: what happens beside the motion, as soon as a condition holds. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_SYNCHRONOUS_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_SYNCHRONOUS_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/*
 * Takes the line, whose first name has been read, if it is a synchronous action (*is): ID=1 WHENEVER ... DO ..., and
 * the like. One that moves no axis and changes no variable of the program is stepped over. False: reported.
 */
bool sinumerik_synchronous_take(struct interp *interp, struct lexer *lexer, const char *name, bool *is);

#endif
