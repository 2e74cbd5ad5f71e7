/* motion_commands.h - sends canonical moves to the sink, for all codes that move axes. */
#ifndef FIVECHECK_GCODE_EXECUTE_MOTION_COMMANDS_H
#define FIVECHECK_GCODE_EXECUTE_MOTION_COMMANDS_H

#include <stdbool.h>

#include "gcode/state.h"

/* Sets the data of a move that depend on the modes and the block, adds the state's spread, and numbers the move. */
void motion_commands_fill(struct interp *interp, struct canon_move *move);

/*
 * Appends to the queue of moves that wait for the end of a compensated move (cutter_comp/comp_queue.h). False: there
 * are too many, which was reported.
 */
bool motion_commands_enqueue(struct interp *interp, const struct comp_item *item);

/*
 * Completes a move by motion_commands_fill and sends it to the sink, or to the queue of waiting moves. False: the sink
 * wants no more, or too many moves wait, which was reported. The same move can be sent again.
 */
bool motion_commands_emit(struct interp *interp, struct canon_move *move);

/* Call it where the block stops the spindle, before state.spindle is changed. False: as motion_commands_emit. */
bool motion_commands_spindle_stops(struct interp *interp);

/*
 * Sets the position of the axes to a straight position (rotated_frame.h), completes *move with that end and sends it.
 * False: the sink wants no more, or a rotary axis may not turn now, which was reported.
 */
bool motion_commands_go(struct interp *interp, const slot_values *target, struct canon_move *move);

/*
 * Covers all places where a probe may have stopped again, after a change of the tool or of the state of the spindle.
 * False: the sink wants no more, or the positions of several axes are uncertain, which was reported at the column.
 */
bool motion_commands_cover_probed(struct interp *interp, int column);

/*
 * The feed, in mm per second, of a thread or per revolution. If it is 0, a caution, and a feed that no axis reaches:
 * posts that lack the data of a tool write a spindle speed or a pitch of 0. There the control stops or waits, but the
 * path is the same.
 */
double motion_commands_thread_feed(struct interp *interp, int column, double feed);

/* The active feed of the block's motion. False: there is none, which was reported. */
bool motion_commands_feed(struct interp *interp, struct canon_feed *feed);

/* The time of a dwell's word in seconds. False: the unit is not known, which was reported. */
bool motion_commands_seconds(const struct interp *interp, char letter, double *seconds);

/* Carries out G4. */
bool motion_commands_dwell(struct interp *interp);

#endif
