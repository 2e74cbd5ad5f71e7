#include "gcode/execute/cycle_hole.h"

#include "gcode/execute/motion_commands.h"

/*
 * mm: LinuxCNC 2.9 stops its rapid this far above the last depth. On other controls a parameter says how far; the rapid
 * stays within the way that the cycle makes in any case.
 */
#define PECK_CLEARANCE 0.254

static bool go(struct canned_cycle *cycle, enum canon_kind kind, double height)
{
	/* Tapping without M3: the cycle starts the spindle itself. */
	bool taps = cycle->code == G74 || cycle->code == G84;
	struct canon_move move = {
	    .kind = kind, .feed = cycle->feed, .spindle_turns = taps && cycle->traits->spindle_must_turn == ANSWER_NO};

	cycle->at.v[cycle->depth] = height;
	return motion_commands_go(cycle->interp, &cycle->at, &move);
}

bool cycle_hole_rapid(struct canned_cycle *cycle, double height)
{
	return go(cycle, CANON_RAPID, height);
}

static bool feed(struct canned_cycle *cycle, double height)
{
	return go(cycle, CANON_FEED, height);
}

static bool rest(struct canned_cycle *cycle)
{
	return !cycle->dwells ||
	       motion_commands_emit(cycle->interp, &(struct canon_move){.kind = CANON_DWELL, .seconds = cycle->dwell});
}

static bool make_pecks(struct canned_cycle *cycle)
{
	double depth = cycle->r - cycle->peck;

	while (depth > cycle->bottom) {
		if (!feed(cycle, depth) || (cycle->code == G83 && !cycle_hole_rapid(cycle, cycle->r)) ||
		    !cycle_hole_rapid(cycle, depth + PECK_CLEARANCE))
			return false;
		depth -= cycle->peck;
	}
	return feed(cycle, cycle->bottom) && cycle_hole_rapid(cycle, cycle->clear);
}

static bool step_aside(struct canned_cycle *cycle, double sign, double height)
{
	cycle->at.v[cycle->a] += sign * cycle->shift_a;
	cycle->at.v[cycle->b] += sign * cycle->shift_b;
	return cycle_hole_rapid(cycle, height);
}

/* G87: goes down beside the axis of the hole, bores upwards on the axis, and leaves the same way. */
static bool bore_back(struct canned_cycle *cycle)
{
	return step_aside(cycle, 1, cycle->r) && cycle_hole_rapid(cycle, cycle->bottom) && step_aside(cycle, -1, cycle->bottom) &&
	       feed(cycle, cycle->top) && feed(cycle, cycle->bottom) && step_aside(cycle, 1, cycle->bottom) &&
	       cycle_hole_rapid(cycle, cycle->clear) && step_aside(cycle, -1, cycle->clear);
}

/* Leaves the hole at the feed as far as R, and on some controls taps and G89 further to the retract height. */
static bool feed_out(struct canned_cycle *cycle)
{
	if (cycle->traits->feeds_to_clear == ANSWER_YES && cycle->code != G85)
		return feed(cycle, cycle->clear);
	return feed(cycle, cycle->r) && cycle_hole_rapid(cycle, cycle->clear);
}

bool cycle_hole_make(struct canned_cycle *cycle)
{
	switch (cycle->code) {
	case G73:
	case G83:
		return make_pecks(cycle);
	case G87:
		return bore_back(cycle);
	case G74:
	case G84:
	case G85:
	case G89:
		return feed(cycle, cycle->bottom) && rest(cycle) && feed_out(cycle);
	default:
		return feed(cycle, cycle->bottom) && rest(cycle) && cycle_hole_rapid(cycle, cycle->clear);
	}
}
