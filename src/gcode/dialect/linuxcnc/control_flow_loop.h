/* control_flow_loop.h - if, while, do and repeat of LinuxCNC. */
#ifndef FIVECHECK_GCODE_DIALECT_LINUXCNC_CONTROL_FLOW_LOOP_H
#define FIVECHECK_GCODE_DIALECT_LINUXCNC_CONTROL_FLOW_LOOP_H

#include <stdbool.h>

#include "gcode/dialect/linuxcnc/oword.h"

struct interp;

/* Carries out a line of a branch or loop whose label has this key. The lexer is after the keyword. False: reported. */
bool control_flow_loop_line(struct interp *interp, struct lexer *lexer, const struct oword *oword, const char *key);

/* The same while lines are skipped, for a line with the key of the skipped branch or loop. */
bool control_flow_loop_skip(struct interp *interp, struct lexer *lexer, const struct oword *oword);

#endif
