/* travel.h - what a block makes the axes do: straight moves, arcs, reference moves, dwells. */
#ifndef FIVECHECK_GCODE_TRAVEL_H
#define FIVECHECK_GCODE_TRAVEL_H

#include <stdbool.h>

#include "gcode/state.h"

/* Sends a move to the sink with what the modes and the block say of it. False: the sink wants no more. */
bool travel_emit(struct interp *interp, const struct canon_move *move);

/* G4. */
bool travel_dwell(struct interp *interp);

/* G28 and G30; G28.1 and G30.1 remember the reference position. */
bool travel_reference(struct interp *interp);
bool travel_remember(struct interp *interp);

/* The block's motion: G0, G1, G2, G3, in machine coordinates with G53; G80. */
bool travel_motion(struct interp *interp);

#endif
