/* parallel_moves.h - a straight move beside which the tool may be far away (canon_move.spread). */
#ifndef FIVECHECK_GCODE_EXECUTE_PARALLEL_MOVES_H
#define FIVECHECK_GCODE_EXECUTE_PARALLEL_MOVES_H

#include "gcode/state.h"
#include "geom/vec3.h"

/* From the middle of a box to the middles of three of its faces: the controller's X, Y and Z, mm. */
struct parallel_box {
	vec3 half[3];
};

/* The box whose sides lie along X, Y and Z. */
struct parallel_box parallel_moves_box(const double spread[3]);

/*
 * As motion_commands_go, but the tool is anywhere in the box about its place on the way. The check of bodies takes a
 * spread as a ball, so a wide move is divided into parallel moves that together cover the same places and whose spread
 * reaches little beyond them (box_cover.h). Where rotary axes turn it stays one move.
 */
bool parallel_moves_go(struct interp *interp, const slot_values *target, const struct canon_move *move,
		       const struct parallel_box *box);

/* The same for a move that starts anywhere in a box that cutter_comp.loose covers too, which stays as it is. */
bool parallel_moves_go_from_open(struct interp *interp, const slot_values *target, struct canon_move *move,
				 const struct parallel_box *box);

#endif
