/* probed_axes.h - axes that a probe has stopped somewhere on its way: which places the following moves must cover. */
#ifndef FIVECHECK_GCODE_EXECUTE_PROBED_AXES_H
#define FIVECHECK_GCODE_EXECUTE_PROBED_AXES_H

#include "gcode/state.h"

/*
 * Where a probe stops is not known, but the set of the places is: for each
 * axis of its way an interval [probe_low, probe_high] of positions, all of
 * which the probe's move has covered, with state->position somewhere inside. A
 * move from there is planned so that what is proved of it holds from every
 * place of the set:
 * - Where the probed axis moves alone, the move first goes to the far end of
 *   the interval. Then its path covers every path, and no more.
 * - Else the move goes from the middle of the intervals, and every position of
 *   it may be as far beside its path as half an interval is long: two paths to
 *   one end are farthest apart at their starts.
 * An absolute coordinate ends the doubt about its axis.
 */
struct probed_plan {
	slot_values via[2];	/* places to go to first */
	int via_count;
	slot_values end;
	double spread[3];	/* mm: as canon_move has it */
};

/* Is the axis' position known? False: a probe has stopped the axis, which was reported at the column. */
bool probed_axes_is_known(struct interp *interp, int slot, int column);

/* Is the set of places known of an axis whose place is not? */
bool probed_axes_any(const struct state *state);

/*
 * Plans the move to these positions; `arc`: other axes move although they may
 * end where they are. False: *open is an axis that cannot be followed: it goes
 * on by an increment beside others.
 */
bool probed_axes_plan(const struct state *state, const slot_values *target, bool arc, struct probed_plan *plan,
		      int *open);

/* The planned move has been made: its absolute coordinates are known, and increments have moved the intervals. */
void probed_axes_arrive(struct state *state, const struct probed_plan *plan);

/*
 * A probe has moved these axes and has stopped anywhere between the places
 * `before` and where they are now. bounded: the set is known, or else nothing is.
 */
void probed_axes_stop(struct state *state, const bool moved[SLOT_COUNT], const struct state *before, bool bounded);

/* The sets are of axis positions: nothing is known of them once the tool point is guided or coordinates are turned. */
void probed_axes_forget_turned(struct state *state);

#endif
