/* sinumerik_flow.h - conditions, loops and jumps. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_FLOW_SINUMERIK_FLOW_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_FLOW_SINUMERIK_FLOW_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/*
 * Carries out a statement such as IF or GOTOF if one comes next: then *done is true. The rest of its line is checked,
 * too. False: reported.
 */
bool sinumerik_flow_run(struct interp *interp, struct lexer *lexer, bool *done);

#endif
