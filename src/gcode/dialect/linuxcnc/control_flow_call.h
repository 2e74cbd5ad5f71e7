/* control_flow_call.h - subprograms of LinuxCNC: sub, endsub, call, return, M98, M99. */
#ifndef FIVECHECK_GCODE_DIALECT_LINUXCNC_CONTROL_FLOW_CALL_H
#define FIVECHECK_GCODE_DIALECT_LINUXCNC_CONTROL_FLOW_CALL_H

#include <stdbool.h>

#include "gcode/dialect/linuxcnc/oword.h"

struct interp;

/* Carries out such a line, or a program's number. The lexer is after the keyword. False: reported. */
bool control_flow_call_line(struct interp *interp, struct lexer *lexer, const struct oword *oword);

/* The same while the body of a subprogram is skipped, or during the search for a subprogram. */
bool control_flow_call_skip(struct interp *interp, struct lexer *lexer, const struct oword *oword);

#endif
