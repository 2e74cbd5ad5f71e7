/*
 * sinumerik_great_circle.h - straight moves under TRAORI whose tool turns in the plane of its two directions
 * (ORIVECT).
 */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_GREAT_CIRCLE_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_GREAT_CIRCLE_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/*
 * Moves to the target (program coordinates) in pieces, along each of which the rotary axes are straight but for
 * canon_move.turn_spread. `direction` (a unit vector, as in kinematics_orientation) is the tool's at the end; NULL: the
 * one to which the target's rotary positions turn it, and they must be those to which the great circle leads. *evenly:
 * nothing has moved, because the circle comes near a pole, where this control turns the axes evenly. False: reported.
 */
bool sinumerik_great_circle_go(struct interp *interp, int column, const slot_values *target, const vec3 *direction,
			       const struct canon_move *move, bool *evenly);

#endif
