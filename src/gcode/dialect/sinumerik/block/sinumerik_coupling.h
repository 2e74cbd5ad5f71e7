/* sinumerik_coupling.h - TRAILON: an axis that follows another one. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_BLOCK_SINUMERIK_COUPLING_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_BLOCK_SINUMERIK_COUPLING_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/*
 * Reads the arguments of TRAILON, whose name stands at the column. False: the coupling moves an axis of the machine
 * file, or it is not known what it moves; reported.
 */
bool sinumerik_coupling_read(struct interp *interp, struct lexer *lexer, int column);

#endif
