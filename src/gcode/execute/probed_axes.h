/* probed_axes.h - the places that moves must cover after a probe has stopped axes at an unknown place of its path. */
#ifndef FIVECHECK_GCODE_EXECUTE_PROBED_AXES_H
#define FIVECHECK_GCODE_EXECUTE_PROBED_AXES_H

#include "gcode/state.h"

/*
 * The place where a probe stops is not known, but the set of possible places is: for each axis that moved, an interval
 * [probe_low, probe_high] of positions, which contains state->position. The probe's move has covered the whole
 * interval. The next move is planned so that its proof is valid for a start from every place of the set:
 * - If only the probed axis moves, the move first goes to the far end of the interval. Then its path covers every
 *   possible path, and no more.
 * - Otherwise the move starts from the middle of the intervals, and every position of it may be off its path by half
 *   the length of the interval: two paths to the same end are farthest apart at their starts.
 * After an absolute coordinate the position of the axis is known again.
 */
struct probed_plan {
	slot_values via[2];	/* places to move to first */
	int via_count;
	slot_values end;
	double spread[3];	/* mm: as in canon_move */
};

/* Is the axis' position known? False: a probe has stopped the axis; this was reported at the column. */
bool probed_axes_is_known(struct interp *interp, int slot, int column);

/* Is there an axis whose position is not known, but whose interval is? */
bool probed_axes_any(const struct state *state);

/*
 * Plans the move to these positions; `arc`: other axes move although their ends may equal their starts. False: the axis
 * *open cannot be followed, because it moves by an increment together with other axes.
 */
bool probed_axes_plan(const struct state *state, const slot_values *target, bool arc, struct probed_plan *plan,
		      int *open);

/* Call after the planned move: axes with absolute coordinates are known, and increments shift the intervals. */
void probed_axes_arrive(struct state *state, const struct probed_plan *plan);

/*
 * Records that a probe has moved these axes and has stopped anywhere between their places in `before` and their present
 * places. bounded: the set of places is known; else nothing is known.
 */
void probed_axes_stop(struct state *state, const bool moved[SLOT_COUNT], const struct state *before, bool bounded);

/* Forgets the intervals: they are axis positions, and are not valid with TCP or in turned coordinates. */
void probed_axes_forget_turned(struct state *state);

#endif
