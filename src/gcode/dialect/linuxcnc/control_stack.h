/* control_stack.h - operations that branches, loops and calls of LinuxCNC share. */
#ifndef FIVECHECK_GCODE_DIALECT_LINUXCNC_CONTROL_STACK_H
#define FIVECHECK_GCODE_DIALECT_LINUXCNC_CONTROL_STACK_H

#include <stdbool.h>

#include "gcode/dialect/linuxcnc/linuxcnc_state.h"
#include "gcode/dialect/linuxcnc/oword.h"

/* Jumps to the line at `to`. False: reported at the column. */
bool control_stack_jump(struct interp *interp, const struct position *to, int column);

/* Skips lines from the current line on. */
void control_stack_skip_to(struct interp *interp, enum skip skip, enum o_kind kind, const char *key, int column);

/* Adds a label for the current line. False: reported. */
bool control_stack_add_label(struct interp *interp, const struct oword *oword, const char *key, struct label **label);

/* Closes the branches and loops beyond the first `count`. */
void control_stack_close(struct control_flow *flow, size_t count);

/* The innermost open branch or loop of the current subprogram; NULL: none. */
struct control *control_stack_top(struct interp *interp);

#endif
