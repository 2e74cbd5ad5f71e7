/* sinumerik_spread.h - straight moves from which the tool may be far away (canon_move.spread). */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_SPREAD_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_SPREAD_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/*
 * motion_commands_go of a straight move with a spread. The check of bodies counts a spread in every direction,
 * so a wide move is divided into parallel moves of a smaller spread, which together cover the same. In turned
 * coordinates, or where rotary axes turn, it stays one move.
 */
bool sinumerik_spread_go(struct interp *interp, const slot_values *target, const struct canon_move *move);

/*
 * The same for a move from the place where a milling cycle has left the tool (sinumerik_open_place.h); for any other
 * move it is motion_commands_go.
 */
bool sinumerik_spread_go_on(struct interp *interp, const slot_values *target, struct canon_move *move);

#endif
