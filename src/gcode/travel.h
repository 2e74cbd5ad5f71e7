/* travel.h - what a block makes the axes do: straight moves, arcs, dwells. */
#ifndef FIVECHECK_GCODE_TRAVEL_H
#define FIVECHECK_GCODE_TRAVEL_H

#include <stdbool.h>

#include "gcode/state.h"

/* Fills in what the modes and the block say of a move, and numbers it. */
void travel_fill(struct interp *interp, struct canon_move *move);

/* Sends a move to the sink with what the modes and the block say of it. False: the sink wants no more. */
bool travel_emit(struct interp *interp, const struct canon_move *move);

/*
 * Goes to a straight position (frame.h) and emits the move that its end
 * completes. False: the sink wants no more, or a rotary axis may not turn now,
 * which was reported.
 */
bool travel_go(struct interp *interp, const slot_values *target, struct canon_move *move);

/* The feed in force for the block's motion. False: there is none, which was reported. */
bool travel_feed(struct interp *interp, struct canon_feed *feed);

/* The number of a dwell's word in seconds. */
double travel_seconds(const struct interp *interp, char letter);

/* G4. */
bool travel_dwell(struct interp *interp);

/* The block's motion, in machine coordinates with G53; G80. */
bool travel_motion(struct interp *interp);

#endif
