/* sinumerik_system_write.h - system variables ($...) that a program may write. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_SYSTEM_WRITE_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_SYSTEM_WRITE_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/*
 * Reads "$P_UIFR[1,X,TR]=5" after its name. A variable without effect on the geometry is read and ignored. False:
 * reported.
 */
bool sinumerik_system_write(struct interp *interp, struct lexer *lexer, const char *name, int column);

#endif
