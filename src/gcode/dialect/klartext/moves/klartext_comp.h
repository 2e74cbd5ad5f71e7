/* klartext_comp.h - radius compensation: RL, RR, R0, M97. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_MOVES_KLARTEXT_COMP_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_MOVES_KLARTEXT_COMP_H

#include <stdbool.h>

#include "gcode/dialect/klartext/moves/klartext_move.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"

/* Has RL or RR been programmed, and no R0 since? */
static inline bool klartext_comp_is_selected(const struct interp *interp)
{
	return interp->comp.side != 0;
}

/* Carries out RL, RR or R0 of a path block, before its move. False: reported, or the sink wants no more. */
bool klartext_comp_switch(struct interp *interp, const struct klartext_words *words, const struct klartext_path *path);

/* The same for a block that does not move. */
bool klartext_comp_switch_standing(struct interp *interp, const struct klartext_words *words);

/* Starts compensation for APPR, whose first move is the next one. */
bool klartext_comp_begin(struct interp *interp, enum klartext_comp comp, int column);

/* Makes a straight move of the tool's centre, before the first compensated move. */
bool klartext_comp_move_bare(struct interp *interp, const struct klartext_path *path);

/* DEP ends compensation: in the next straight move; or at the present position of the tool's centre. */
bool klartext_comp_leave(struct interp *interp, const struct klartext_path *path, int column);
bool klartext_comp_leave_standing(struct interp *interp, int column);

/* Makes the move of a path; while compensation is on, beside the path. False: the same. */
bool klartext_comp_go(struct interp *interp, const struct klartext_target *target, const struct klartext_path *path);

/* Call after a block has moved the named axes: after R0, the position in the plane may be known again. */
void klartext_comp_settle(struct interp *interp, const struct klartext_words *words);

/* Call when the coordinates turn: an uncertainty along one of their axes may then be along every axis. */
void klartext_comp_turn_open(struct interp *interp);

/* Checks that no path is relative to the position after R0 without a move. False: reported. */
bool klartext_comp_check_known(struct interp *interp, int column, const char *what);

/* Call at the end of the program: waiting moves end at their present ends. False: reported, or the sink ... */
bool klartext_comp_end(struct interp *interp, int column);

#endif
