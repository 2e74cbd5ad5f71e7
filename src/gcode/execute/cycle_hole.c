#include "gcode/execute/cycle_hole.h"

#include <math.h>

#include "gcode/execute/motion_commands.h"

/*
 * mm: LinuxCNC 2.9 stops its rapid this far above the last depth. On other controls a parameter gives this distance;
 * the rapid is part of the cycle's path in any case.
 */
#define PECK_CLEARANCE 0.254

static bool go(struct canned_cycle *cycle, enum canon_kind kind, double height)
{
	/* Tapping without M3: the cycle starts the spindle itself. */
	bool taps = (cycle->code == G74 || cycle->code == G84) && cycle->traits->spindle_must_turn == ANSWER_NO;
	struct canon_move move = {.kind = kind,
				  .feed = cycle->feed,
				  .spindle_turns = taps,
				  .turn = taps ? TURN_OF_TAP : TURN_UNKNOWN};

	/* In turned coordinates the plane may have any direction. */
	for (int slot = SLOT_X; slot <= SLOT_Z && cycle->aside; slot++)
		move.spread[slot] = slot == (int)cycle->depth && !cycle->interp->state.frame.on ? 0 : cycle->spread;
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
	double peck = cycle->peck, depth = cycle->r - peck;

	while (depth > cycle->bottom) {
		if (!feed(cycle, depth) || (cycle->code == G83 && !cycle_hole_rapid(cycle, cycle->r)) ||
		    !cycle_hole_rapid(cycle, depth + PECK_CLEARANCE))
			return false;
		peck = fmax(peck - cycle->peck_less, cycle->peck_least);
		depth -= peck;
	}
	return feed(cycle, cycle->bottom) && cycle_hole_rapid(cycle, cycle->clear);
}

static bool step_aside(struct canned_cycle *cycle, double sign, double height)
{
	cycle->at.v[cycle->a] += sign * cycle->shift_a;
	cycle->at.v[cycle->b] += sign * cycle->shift_b;
	return cycle_hole_rapid(cycle, height);
}

/* A rapid on which the distance of the tool from the axis of the hole is at most the spread. */
static bool rapid_aside(struct canned_cycle *cycle, double height)
{
	bool good;

	cycle->aside = true;
	good = cycle_hole_rapid(cycle, height);
	cycle->aside = false;
	return good;
}

/* G76: stops the spindle in its orientation, shifts the tool aside at the bottom, and back above the hole. */
static bool bore_finely(struct canned_cycle *cycle)
{
	bool known = !(cycle->spread > 0);

	if (!feed(cycle, cycle->bottom) || !rest(cycle))
		return false;
	if (!known)
		return rapid_aside(cycle, cycle->clear);
	return step_aside(cycle, 1, cycle->bottom) && cycle_hole_rapid(cycle, cycle->clear) &&
	       step_aside(cycle, -1, cycle->clear);
}

/*
 * Moves down to R beside the axis of the hole, up to Z on the axis, and out beside the axis. The tool may leave from Z
 * or from R: the path down has covered the places below Z.
 */
static bool bore_upwards(struct canned_cycle *cycle)
{
	return rapid_aside(cycle, cycle->r) && feed(cycle, cycle->bottom) && rapid_aside(cycle, cycle->clear);
}

/* The spindle stops, and the operator retracts the tool by hand: only straight up can be followed. */
static bool bore_by_hand(struct canned_cycle *cycle)
{
	struct interp *interp = cycle->interp;

	if (!interp->cautioned_by_hand)
		caution(
		    &interp->at, block_motion_column(&interp->block),
		    "G%d: the operator retracts the tool by hand; only a retract straight up is checked, here and "
		    "further on",
		    cycle->code / 10);
	interp->cautioned_by_hand = true;
	return feed(cycle, cycle->bottom) && rest(cycle) && cycle_hole_rapid(cycle, cycle->clear);
}

/* G87: moves down beside the axis of the hole, bores upwards on the axis, and leaves by the same path. */
static bool bore_back(struct canned_cycle *cycle)
{
	return step_aside(cycle, 1, cycle->r) && cycle_hole_rapid(cycle, cycle->bottom) &&
	       step_aside(cycle, -1, cycle->bottom) &&
	       feed(cycle, cycle->top) && feed(cycle, cycle->bottom) && step_aside(cycle, 1, cycle->bottom) &&
	       cycle_hole_rapid(cycle, cycle->clear) && step_aside(cycle, -1, cycle->clear);
}

/* Leaves the hole at the feed up to R; on some controls taps and G89 feed up to the retract height. */
static bool feed_out(struct canned_cycle *cycle)
{
	if (cycle->traits->feeds_to_clear == ANSWER_YES && cycle->code != G85)
		return feed(cycle, cycle->clear);
	return feed(cycle, cycle->r) && cycle_hole_rapid(cycle, cycle->clear);
}

bool cycle_hole_bores_back(const struct canned_cycle *cycle)
{
	return cycle->code == G77 || (cycle->code == G87 && cycle->traits->g87 == G87_BACK_BY_Q);
}

/* R and Z in the wrong order: moves to R, down by one peck, to Z and out, with the shift of bores aside. */
static bool cross_over(struct canned_cycle *cycle)
{
	cycle->aside = cycle->spread > 0;
	return cycle_hole_rapid(cycle, cycle->r) && (!(cycle->peck > 0) || feed(cycle, cycle->r - cycle->peck)) &&
	       feed(cycle, cycle->bottom) && rest(cycle) && cycle_hole_rapid(cycle, cycle->clear);
}

bool cycle_hole_make(struct canned_cycle *cycle)
{
	if (cycle->crosses) {
		bool good = cross_over(cycle);

		cycle->aside = false;
		return good;
	}
	switch (cycle->code) {
	case G73:
	case G83:
		return make_pecks(cycle);
	case G76:
		return bore_finely(cycle);
	case G77:
		return bore_upwards(cycle);
	case G87:
		return cycle->traits->g87 == G87_BACK_BY_IJK ? bore_back(cycle)
		       : cycle->traits->g87 == G87_BACK_BY_Q ? bore_upwards(cycle)
							     : bore_by_hand(cycle);
	case G88:
		return bore_by_hand(cycle);
	case G74:
	case G84:
	case G85:
	case G89:
		return feed(cycle, cycle->bottom) && rest(cycle) && feed_out(cycle);
	default:
		return feed(cycle, cycle->bottom) && rest(cycle) && cycle_hole_rapid(cycle, cycle->clear);
	}
}
