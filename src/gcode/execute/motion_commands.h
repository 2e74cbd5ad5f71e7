/* motion_commands.h - canonical moves to the sink: what every code that moves axes calls. */
#ifndef FIVECHECK_GCODE_EXECUTE_MOTION_COMMANDS_H
#define FIVECHECK_GCODE_EXECUTE_MOTION_COMMANDS_H

#include <stdbool.h>

#include "gcode/state.h"

/* Fills in, and adds to, what the modes and the block say about a move, and numbers it. */
void motion_commands_fill(struct interp *interp, struct canon_move *move);

/*
 * Appends to the moves that wait until the end of a compensated move is known
 * (cutter_comp/comp_queue.h). False: there are too many, which was reported.
 */
bool motion_commands_enqueue(struct interp *interp, const struct comp_item *item);

/*
 * Completes a move by motion_commands_fill and sends it to the sink, or to the
 * moves that wait. False: the sink wants no more, or too many moves wait, which
 * was reported. The same move can be sent again.
 */
bool motion_commands_emit(struct interp *interp, struct canon_move *move);

/* To be called where the block stops the spindle, before state.spindle says so. False: as motion_commands_emit. */
bool motion_commands_spindle_stops(struct interp *interp);

/*
 * Sets the position of the axes to a straight position (rotated_frame.h),
 * completes *move with that end and sends it. False: the sink wants no more, or
 * a rotary axis may not turn now, which was reported.
 */
bool motion_commands_go(struct interp *interp, const slot_values *target, struct canon_move *move);

/*
 * Goes over all places where a probe may have stopped, as what stands there has changed: the tool, or its spindle.
 * False: the sink wants no more, or several axes are in doubt, which was reported at the column.
 */
bool motion_commands_cover_probed(struct interp *interp, int column);

/* The feed in force for the block's motion. False: there is none, which was reported. */
bool motion_commands_feed(struct interp *interp, struct canon_feed *feed);

/* The number of a dwell's word in seconds. False: its unit is not known, which was reported. */
bool motion_commands_seconds(const struct interp *interp, char letter, double *seconds);

/* Carries out G4. */
bool motion_commands_dwell(struct interp *interp);

#endif
