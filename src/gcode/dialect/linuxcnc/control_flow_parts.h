/* control_flow_parts.h - what the files of control_flow share. */
#ifndef FIVECHECK_GCODE_DIALECT_LINUXCNC_CONTROL_FLOW_PARTS_H
#define FIVECHECK_GCODE_DIALECT_LINUXCNC_CONTROL_FLOW_PARTS_H

#include <stdbool.h>

#include "gcode/dialect/linuxcnc/control_flow.h"
#include "gcode/dialect/linuxcnc/oword.h"
#include "gcode/state.h"
#include "gcode/text/lexer.h"

/* The next line in hand is the one at `to`. False: reported at the column. */
bool control_flow_jump(struct interp *interp, const struct position *to, int column);

void control_flow_skip_to(struct interp *interp, enum skip skip, enum o_kind kind, const char *key, int column);

/* A new label at the line in hand. False: reported. */
bool control_flow_add_label(struct interp *interp, const struct oword *oword, const char *key, struct label **label);

/* Closes the branches and loops beyond the first `count`. */
void control_flow_close_controls(struct control_flow *flow, size_t count);

/* The innermost branch or loop that the subprogram in hand has open; NULL: none. */
struct control *control_flow_top_control(struct interp *interp);

/* A line of a branch or loop whose label has this key, and one with the key that is skipped for. */
bool control_flow_loop_line(struct interp *interp, struct lexer *lexer, const struct oword *oword, const char *key);
bool control_flow_loop_skip(struct interp *interp, struct lexer *lexer, const struct oword *oword);

/* sub, endsub, call, return, a program number, M98, M99, of a line that is not skipped. */
bool control_flow_call_line(struct interp *interp, struct lexer *lexer, const struct oword *oword);

/* Such a line while the body of a subprogram is skipped, or one is looked for. */
bool control_flow_call_skip(struct interp *interp, struct lexer *lexer, const struct oword *oword);

#endif
