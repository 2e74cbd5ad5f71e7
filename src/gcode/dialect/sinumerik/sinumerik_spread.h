/* sinumerik_spread.h - straight moves beside which the tool may be far aside. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_SPREAD_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_SPREAD_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/*
 * motion_commands_go of a straight move with its spread: as many parallel moves that each spread less and cover the same
 * together, as a spread counts in every direction where bodies are checked. In turned coordinates, or where rotary axes
 * turn, it stays one move.
 */
bool sinumerik_spread_go(struct interp *interp, const slot_values *target, const struct canon_move *move);

/* The same from where a milling cycle has left the tool (sinumerik_open_place.h); elsewhere it is motion_commands_go. */
bool sinumerik_spread_go_on(struct interp *interp, const slot_values *target, struct canon_move *move);

#endif
