/* klartext_comp.h - radius compensation: RL, RR, R0, M97. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_COMP_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_COMP_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_move.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"

/* Has RL or RR been programmed, and no R0 since? */
static inline bool klartext_comp_is_selected(const struct interp *interp)
{
	return interp->comp.side != 0;
}

/* RL, RR or R0 of a path block, before its move. False: reported, or the sink wants no more. */
bool klartext_comp_switch(struct interp *interp, const struct klartext_words *words, const struct klartext_path *path);

/* The same of a block that does not move. */
bool klartext_comp_switch_standing(struct interp *interp, const struct klartext_words *words);

/* Starts it for APPR, whose first move is the next one. */
bool klartext_comp_begin(struct interp *interp, enum klartext_comp comp, int column);

/* A straight move of the tool's centre itself, before the first one beside the path. */
bool klartext_comp_move_bare(struct interp *interp, const struct klartext_path *path);

/* DEP ends it: in the straight move that comes next; or where the tool's centre stands beside the path. */
bool klartext_comp_leave(struct interp *interp, const struct klartext_path *path, int column);
bool klartext_comp_leave_standing(struct interp *interp, int column);

/* Makes the move of a path: beside it while compensation is on. False: the same. */
bool klartext_comp_go(struct interp *interp, const struct klartext_target *target, const struct klartext_path *path);

/* A block has moved the axes named: where the tool stands in the plane may be known again behind R0. */
void klartext_comp_settle(struct interp *interp, const struct klartext_words *words);

/* The coordinates turn: what was open along one of their axes may be open along any. */
void klartext_comp_turn_open(struct interp *interp);

/* No path may be counted from where the tool stands behind R0 without a move. False: reported. */
bool klartext_comp_check_known(struct interp *interp, int column, const char *what);

/* The program ends here: what waits ends where it is. False: reported, or the sink wants no more. */
bool klartext_comp_end(struct interp *interp, int column);

#endif
