/* sinumerik_flow.h - conditions, loops and jumps. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_FLOW_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_FLOW_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/*
 * Carries out the statement if one comes next, such as IF or GOTOF; *done tells. What stands behind it in the line is
 * looked at, too. False: reported.
 */
bool sinumerik_flow_run(struct interp *interp, struct lexer *lexer, bool *done);

#endif
