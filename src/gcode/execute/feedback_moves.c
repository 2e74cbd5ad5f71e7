#include "gcode/execute/feedback_moves.h"

#include <math.h>

#include "base/same_double.h"
#include "base/units.h"
#include "gcode/execute/endpoint.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/probed_axes.h"
#include "gcode/execute/rotated_frame.h"

/* K is the path length for one revolution of the spindle. */
static bool find_pitch_feed(struct interp *interp, struct canon_feed *feed)
{
	const struct block *block = &interp->block;
	const struct state *state = &interp->state;
	int column = block_motion_column(block);
	const char *tenths = block->motion == G33_1 ? ".1" : "";

	if (!block_has(block, 'K'))
		return fault(&interp->at, column, "G33%s needs K (pitch)", tenths);
	if (block_has(block, 'F'))
		return fault(&interp->at, block_column(block, 'F'),
			     "F with G33%s: the feed is the pitch times the spindle speed; remove F", tenths);
	if (state->spindle == SPINDLE_STOPPED || !(state->speed > 0))
		return fault(&interp->at, column, "G33%s with a stopped spindle", tenths);
	feed->linear = fabs(block_value(block, 'K')) * state->scale * state->speed / SECONDS_PER_MINUTE;
	feed->angular = radians(fabs(block_value(block, 'K')) * state->speed) / SECONDS_PER_MINUTE;
	if (!(feed->linear > 0))
		return fault(&interp->at, block_column(block, 'K'), "the pitch is 0");
	return true;
}

static bool tap(struct interp *interp, const slot_values *target, struct canon_move *move)
{
	const struct block *block = &interp->block;
	slot_values start = rotated_frame_straight(&interp->state);

	for (int slot = SLOT_A; slot < SLOT_COUNT; slot++) {
		if (block_has(block, AXIS_LETTERS[slot]))
			return fault(&interp->at, block_column(block, AXIS_LETTERS[slot]),
				     "%c with G33.1, which moves only X, Y and Z", AXIS_LETTERS[slot]);
	}
	/* Down and back to the start; the retract is I times as fast if I > 1. */
	if (!motion_commands_go(interp, target, move))
		return false;
	if (block_has(block, 'I'))
		move->feed.linear *= fmax(1, block_value(block, 'I'));
	return motion_commands_go(interp, &start, move);
}

static bool is_skip(int code)
{
	return code >= G31 && code <= G31_3;
}

/* G38.2 and G38.4 must find something on their path, so the path cannot be empty. */
static bool check_probe(struct interp *interp, const slot_values *target)
{
	const struct block *block = &interp->block;
	slot_values start = rotated_frame_straight(&interp->state);
	int column = block_motion_column(block);

	if (interp->comp.side != 0)
		return fault(&interp->at, column, "probing under cutter compensation; write G40 first");
	/* Fanuc B-64484EN and Haas, "G31": a move without a signal is no error, and G95 is a feed like any other. */
	if (is_skip(block->motion))
		return true;
	if (interp->state.feed_mode == FEED_PER_REVOLUTION)
		return fault(&interp->at, column,
			     "G38.%d in feed per revolution (G95); write G94 first", block->motion % 10);
	if (block->motion != G38_2 && block->motion != G38_4)
		return true;
	return !slot_values_same(target, &start) ||
	       fault(&interp->at, column, "G38.%d ends where the probe already stands, and does not move it",
		     block->motion % 10);
}

/* The probe stops where it finds something, or at the end of its path. */
static bool probe(struct interp *interp, const slot_values *target, struct canon_move *move)
{
	struct state *state = &interp->state, before = *state;
	bool named[SLOT_COUNT], bounded = state->tcp == TCP_OFF && !state->frame.on && interp->comp.side == 0;

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		bool word = block_has(&interp->block, AXIS_LETTERS[slot]);

		/* Under TCP and in turned coordinates each coordinate of the tool point may move all linear axes. */
		named[slot] = word || (slot <= SLOT_Z && (state->tcp != TCP_OFF || state->frame.on));
		bounded = bounded && !(word && slot > SLOT_Z);
	}
	move->may_stop = true;
	if (!motion_commands_go(interp, target, move))
		return false;
	probed_axes_stop(state, named, &before, bounded);
	return true;
}

/* The start of a thread must be known. */
static bool check_start(struct interp *interp)
{
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!probed_axes_is_known(interp, slot, block_motion_column(&interp->block)))
			return false;
	}
	return true;
}

bool feedback_moves_run(struct interp *interp)
{
	int code = interp->block.motion;
	bool pitch = code == G33 || code == G33_1;
	struct canon_move move = {.kind = CANON_FEED};
	slot_values target;

	if (pitch ? !find_pitch_feed(interp, &move.feed) : !motion_commands_feed(interp, &move.feed))
		return false;
	/* G31 is valid for its block only. */
	if (!is_skip(code))
		interp->state.motion = code;
	if (!endpoint_find(interp, false, &target))
		return false;
	if (!pitch)
		return check_probe(interp, &target) && probe(interp, &target, &move);
	if (!check_start(interp))
		return false;
	return code == G33_1 ? tap(interp, &target, &move) : motion_commands_go(interp, &target, &move);
}
