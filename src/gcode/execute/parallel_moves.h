/* parallel_moves.h - a straight move whose true path may be far from the programmed one (canon_move.spread). */
#ifndef FIVECHECK_GCODE_EXECUTE_PARALLEL_MOVES_H
#define FIVECHECK_GCODE_EXECUTE_PARALLEL_MOVES_H

#include "gcode/state.h"
#include "geom/vec3.h"

/* Vectors from the centre of a box to the middles of three of its faces: the controller's X, Y and Z, mm. */
struct parallel_box {
	vec3 half[3];
};

/* The box with sides along X, Y and Z. */
struct parallel_box parallel_moves_box(const double spread[3]);

/*
 * As motion_commands_go, but the tool may be anywhere in the box about its place on the path. The check of bodies
 * treats a spread as a ball, so a move with a large box is divided into parallel moves that together cover the same
 * places and whose spreads extend little beyond these (box_cover.h). A move that turns rotary axes is not divided.
 */
bool parallel_moves_go(struct interp *interp, const slot_values *target, const struct canon_move *move,
		       const struct parallel_box *box);

/* The same for a move that starts anywhere in a box that includes cutter_comp.loose, which is not changed. */
bool parallel_moves_go_from_open(struct interp *interp, const slot_values *target, struct canon_move *move,
				 const struct parallel_box *box);

#endif
