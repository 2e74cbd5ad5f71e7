/* parallel_moves.h - a straight move beside which the tool may be far away (canon_move.spread). */
#ifndef FIVECHECK_GCODE_EXECUTE_PARALLEL_MOVES_H
#define FIVECHECK_GCODE_EXECUTE_PARALLEL_MOVES_H

#include "gcode/state.h"

/*
 * As motion_commands_go. The check of bodies counts a spread in every direction, so a wide move is divided into
 * parallel moves of a smaller spread, which together cover the same box. In turned coordinates, or where rotary axes
 * turn, it stays one move.
 */
bool parallel_moves_go(struct interp *interp, const slot_values *target, const struct canon_move *move);

/* The same for a move that starts anywhere in the box that cutter_comp.loose gives, which stays as it is. */
bool parallel_moves_go_from_open(struct interp *interp, const slot_values *target, struct canon_move *move);

#endif
