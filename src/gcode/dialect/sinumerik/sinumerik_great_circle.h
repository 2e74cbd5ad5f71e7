/* sinumerik_great_circle.h - straight moves under TRAORI whose tool turns in the plane of its two directions (ORIVECT). */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_GREAT_CIRCLE_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_GREAT_CIRCLE_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/*
 * Moves to the target (program coordinates) in pieces, along each of which the rotary axes are straight but for
 * canon_move.turn_spread. `direction` (a unit, as kinematics_orientation has it) is where the tool ends up; NULL: where
 * the target's rotary positions turn it, which must be those that the way leads to. *evenly: nothing has moved; the way comes near a pole, where this control
 * turns the axes evenly. False: reported.
 */
bool sinumerik_great_circle_go(struct interp *interp, int column, const slot_values *target, const vec3 *direction,
			       const struct canon_move *move, bool *evenly);

#endif
