/* flow_parts.h - what flow.c, flow_loop.c and flow_call.c share. */
#ifndef FIVECHECK_GCODE_FLOW_PARTS_H
#define FIVECHECK_GCODE_FLOW_PARTS_H

#include <stdbool.h>

#include "gcode/flow.h"
#include "gcode/lexer.h"
#include "gcode/oword.h"
#include "gcode/state.h"

/* The next line in hand is the one at `to`. False: reported at the column. */
bool flow_jump(struct interp *interp, const struct position *to, int column);

void flow_skip_to(struct interp *interp, enum skip skip, enum o_kind kind, const char *key, int column);

/* A new label at the line in hand. False: reported. */
bool flow_add_label(struct interp *interp, const struct oword *oword, const char *key, struct label **label);

/* Closes the branches and loops beyond the first `count`. */
void flow_close_controls(struct flow *flow, size_t count);

/* The innermost branch or loop that the subprogram in hand has open; NULL: none. */
struct control *flow_top_control(struct interp *interp);

/* A line of a branch or loop whose label has this key, and one with the key that is skipped for. */
bool flow_loop_line(struct interp *interp, struct lexer *lexer, const struct oword *oword, const char *key);
bool flow_loop_skip(struct interp *interp, struct lexer *lexer, const struct oword *oword);

/* sub, endsub, call, return, a program number, M98, M99, of a line that is not skipped. */
bool flow_call_line(struct interp *interp, struct lexer *lexer, const struct oword *oword);

/* Such a line while the body of a subprogram is skipped, or one is looked for. */
bool flow_call_skip(struct interp *interp, struct lexer *lexer, const struct oword *oword);

#endif
