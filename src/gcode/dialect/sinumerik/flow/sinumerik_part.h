/* sinumerik_part.h - parts of a program between labels: REPEAT and REPEATB repeat them, CALL BLOCK calls them. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_FLOW_SINUMERIK_PART_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_FLOW_SINUMERIK_PART_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/* What follows REPEAT, or REPEATB if it is one `block`: LABEL [LABEL] [P=n]. False: reported. */
bool sinumerik_part_repeat(struct interp *interp, struct lexer *lexer, bool block);

/* What follows CALL BLOCK: LABEL TO LABEL. False: reported. */
bool sinumerik_part_call(struct interp *interp, struct lexer *lexer);

#endif
