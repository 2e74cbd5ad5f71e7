/* sinumerik_synchronous.h - synchronous actions: they run beside the motion as soon as a condition is true. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_BLOCK_SINUMERIK_SYNCHRONOUS_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_BLOCK_SINUMERIK_SYNCHRONOUS_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/*
 * Reads the line, whose first name has been read, if it is a synchronous action (*is): ID=1 WHENEVER ... DO ..., and
 * the like. An action that moves no axis and changes no variable of the program is skipped. False: reported.
 */
bool sinumerik_synchronous_take(struct interp *interp, struct lexer *lexer, const char *name, bool *is);

#endif
