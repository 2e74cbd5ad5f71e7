/* sinumerik_traori.h - the transformation that TRAORI switches on. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_BLOCK_SINUMERIK_TRAORI_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_BLOCK_SINUMERIK_TRAORI_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/*
 * Reads what follows TRAORI. Nothing and (1) select the first transformation that the builder has configured, whose
 * tool is parallel to Z; others are refused. False: reported.
 */
bool sinumerik_traori_read(struct interp *interp, struct lexer *lexer);

#endif
