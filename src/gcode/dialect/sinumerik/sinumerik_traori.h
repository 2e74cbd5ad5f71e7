/* sinumerik_traori.h - the transformation that TRAORI switches on. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_TRAORI_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_TRAORI_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/*
 * What stands behind TRAORI: nothing and (1) are the first transformation that the machine's maker has set up, whose
 * tool lies along Z; others are refused. False: reported.
 */
bool sinumerik_traori_read(struct interp *interp, struct lexer *lexer);

#endif
