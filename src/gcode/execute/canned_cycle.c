#include "gcode/execute/canned_cycle.h"

#include "gcode/execute/cycle_heights.h"
#include "gcode/execute/cycle_hole.h"
#include "gcode/execute/cycle_pecks.h"
#include "gcode/execute/cycle_shift.h"
#include "gcode/execute/cycle_words.h"
#include "gcode/execute/endpoint.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/polar_coordinates.h"
#include "gcode/execute/probed_axes.h"
#include "gcode/execute/rotated_frame.h"
#include "gcode/execute/tool_length.h"

/* ------------------------------------------------------------------ words */

/* Are the words of the cycle before still valid? */
static bool keeps_words(const struct canned_cycle *cycle)
{
	int before = cycle->interp->state.motion;

	if (cycle->traits->words_outlive_cycle == ANSWER_NO)
		return before == cycle->code;
	return before != CODE_NONE && code_is_cycle(before);
}

static bool find_axes(struct canned_cycle *cycle)
{
	const struct interp *interp = cycle->interp;
	const enum cycle_axis told = interp->config->controller.cycle_axis;
	const bool asks = cycle->traits->axis_by_parameter == ANSWER_YES && interp->state.plane != G17;
	const int plane = asks && told == CYCLE_AXIS_Z ? G17 : interp->state.plane;

	cycle->a = plane == G17 ? SLOT_X : plane == G18 ? SLOT_Z : SLOT_Y;
	cycle->b = plane == G17 ? SLOT_Y : plane == G18 ? SLOT_X : SLOT_Z;
	cycle->depth = plane == G17 ? SLOT_Z : plane == G18 ? SLOT_Y : SLOT_X;
	return !asks || told ||
	       fault(&interp->at, block_motion_column(&interp->block),
		     "a parameter of the control (5101#0, FXY) decides whether G%d drills along %c or Z in the plane "
		     "of G%d: set cycle_axis=\"plane\" or \"z\" in the machine file's <controller>",
		     cycle->code / 10, AXIS_LETTERS[cycle->depth], plane / 10);
}

static bool find_dwell(struct canned_cycle *cycle, bool kept)
{
	struct interp *interp = cycle->interp;
	const struct cycle_memory *memory = &interp->state.cycle;
	bool given = block_has(&interp->block, 'P');
	bool by_code = cycle->traits->p_is_needed == ANSWER_YES;
	bool needed = by_code && (cycle->code == G82 || cycle->code == G86 || cycle->code == G89);
	bool optional =
	    cycle->code != G73 && cycle->code != G81 && cycle->code != G83 && cycle->code != G85 && cycle->code != G87;

	if (!needed && !optional)
		return true;
	/* LinuxCNC's taps use the dwell of the cycle before, whatever its code. */
	kept = kept || (by_code && !needed);
	cycle->dwells = by_code || given || (kept && (memory->known & letter_bit('P')));
	if (!given && !needed && !(kept && (memory->known & letter_bit('P'))))
		return true;
	if (given && block_value(&interp->block, 'P') < 0)
		return fault(&interp->at, block_column(&interp->block, 'P'), "a dwell must not be negative");
	if (given && !motion_commands_seconds(interp, 'P', &interp->block.value['P' - 'A']))
		return false;
	return cycle_words_take(cycle, 'P', kept, &cycle->dwell);
}

/* L or K: the number of holes, one step of G91 apart. */
static bool find_repeats(struct canned_cycle *cycle)
{
	struct interp *interp = cycle->interp;
	const struct block *block = &interp->block;
	bool asks = cycle->traits->repeat_letter == 'K';
	bool by_l = asks && interp->config->controller.cycle_repeats == CYCLE_REPEATS_L;
	char letter = by_l ? 'L' : cycle->traits->repeat_letter;

	cycle->repeats = 1;
	/* Fanuc's parameter 0001#1 (FCV) selects the format of Series 15, where L repeats, as before Series 16. */
	if (asks && !by_l && block_has(block, 'L'))
		return fault(&interp->at, block_column(block, 'L'),
			     "L in a canned cycle: K repeats the cycle, unless a parameter of the control assigns this "
			     "to L: if so, set cycle_repeats=\"L\" in the machine file's <controller>");
	if (by_l && block_has(block, 'K'))
		return fault(&interp->at, block_column(block, 'K'), "no code in the block uses the word K");
	if (!block_has(block, letter))
		return true;
	if (!block_integer(block, &interp->at, letter, 0, CYCLE_COUNT_MAX, &cycle->repeats))
		return false;
	if (cycle->repeats == 0 && cycle->traits->zero_repeats_refused == ANSWER_YES)
		return fault(&interp->at, block_column(block, letter), "G%g must not be repeated 0 times",
			     cycle->code / 10.0);
	/* The words are kept and nothing is drilled; controls differ in whether the tool moves to the position. */
	if (cycle->repeats == 0 && (block->letters & AXIS_BITS & ~letter_bit(AXIS_LETTERS[cycle->depth])))
		return fault(&interp->at, block_column(block, letter),
			     "%c0 with a position: controls differ in whether the tool moves there; remove one of them",
			     letter);
	return true;
}

/* Finds the positions of the holes; rotary axes may move there, too, if the control allows it. */
static bool find_holes(struct canned_cycle *cycle)
{
	struct interp *interp = cycle->interp;
	const struct state *state = &interp->state;
	slot_values target;

	for (int slot = 0; slot < SLOT_COUNT && cycle->traits->only_xyz == ANSWER_YES; slot++) {
		if (slot > SLOT_Z && block_has(&interp->block, AXIS_LETTERS[slot]))
			return fault(&interp->at, block_column(&interp->block, AXIS_LETTERS[slot]),
				     "%c in a canned cycle, which moves only X, Y and Z", AXIS_LETTERS[slot]);
	}
	if (!endpoint_find(interp, false, &target) ||
	    tool_length_is_in_doubt(interp, (int)cycle->depth, block_motion_column(&interp->block)))
		return false;
	target.v[cycle->depth] = cycle->at.v[cycle->depth];
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		double way = target.v[slot] - cycle->at.v[slot];

		cycle->step.v[slot] = state->incremental ? way : 0;
		if (!state->incremental)
			cycle->at.v[slot] = target.v[slot];
	}
	return true;
}

/* LinuxCNC up to 2.9 (interp_cycles.cc) exchanges the coordinates of its taps for the plane twice. */
static bool check_tap_plane(struct canned_cycle *cycle)
{
	struct interp *interp = cycle->interp;

	if (cycle->traits->taps_confuse_planes == ANSWER_NO || interp->state.plane == G17 ||
	    (cycle->code != G74 && cycle->code != G84))
		return true;
	return fault(&interp->at, block_motion_column(&interp->block),
		     "G%d in the plane of G%d: this control mixes up the axes and moves elsewhere; use G33.1",
		     cycle->code / 10, interp->state.plane / 10);
}

static bool check_spindle(struct canned_cycle *cycle)
{
	struct interp *interp = cycle->interp;
	enum spindle_turn turn = interp->state.spindle;
	int column = block_motion_column(&interp->block), code = cycle->code;

	if (cycle->traits->spindle_must_turn == ANSWER_NO || (code != G74 && code != G84 && code != G86 && code != G87))
		return true;
	if (turn == SPINDLE_STOPPED)
		return fault(&interp->at, column, "G%d with a stopped spindle", code / 10);
	if (code == (turn == SPINDLE_CLOCKWISE ? G74 : G84))
		return fault(&interp->at, column, "G%d while the spindle runs %s", code / 10,
			     turn == SPINDLE_CLOCKWISE ? "clockwise" : "counter-clockwise");
	return true;
}

/* ------------------------------------------------------------------ holes */

/*
 * Moves over the next hole and down to R. On controls whose cycles rise first, the tool moves to the first hole at the
 * present height if that is above R, and to any other hole at the retract height.
 */
static bool go_over(struct canned_cycle *cycle, bool first, double height)
{
	bool rises = cycle->traits->rises_first == ANSWER_YES;
	double over = !rises || (first && height > cycle->r) ? height : cycle->clear;

	if (!cycle_hole_rapid(cycle, over))
		return false;
	if (cycle_hole_bores_back(cycle))
		return true;
	if (rises && !(over > cycle->r))
		return true;
	return cycle_hole_rapid(cycle, cycle->r);
}

static bool make_holes(struct canned_cycle *cycle)
{
	const struct state *state = &cycle->interp->state;
	double height = cycle->at.v[cycle->depth];

	for (int i = 0; i < cycle->repeats; i++) {
		bool turns = i > 0 && state->polar.on && state->incremental;

		for (int slot = 0; slot < SLOT_COUNT && !turns; slot++)
			cycle->at.v[slot] += cycle->step.v[slot];
		if (turns && !polar_coordinates_find(cycle->interp, &cycle->at))
			return false;
		if (!go_over(cycle, i == 0, height) || !cycle_hole_make(cycle))
			return false;
		height = cycle->at.v[cycle->depth];
	}
	return true;
}

/* On controls whose cycles rise first: a tool below R rises to R. */
static bool rise(struct canned_cycle *cycle)
{
	const struct state *state = &cycle->interp->state;
	double level = state->cycle.level * state->scale + state->offset.v[cycle->depth];

	return cycle->traits->rises_first == ANSWER_NO || !(level < cycle->r) || cycle_hole_rapid(cycle, cycle->r);
}

static bool make_cycle(struct canned_cycle *cycle)
{
	struct state *state = &cycle->interp->state;
	bool blend = state->blend, good;

	if (!rise(cycle) || !find_holes(cycle))
		return false;
	if (cycle->traits->exact_path == ANSWER_YES)
		state->blend = false;
	good = make_holes(cycle);
	state->blend = blend;
	return good;
}

/* On controls where a cycle may have no axis words, only blocks with an axis word drill. */
static bool is_to_drill(struct canned_cycle *cycle, bool *good)
{
	const struct block *block = &cycle->interp->block;
	bool axes = block->letters & AXIS_BITS;

	*good = true;
	if (cycle->traits->without_axes == ANSWER_NO)
		return true;
	if (cycle->repeats > 0 && !axes && block_has(block, 'R'))
		*good = fault(&cycle->interp->at, block_column(block, 'R'),
			      "R of G%d without an axis word: controls differ in whether they drill at the present "
			      "position; write an axis word",
			      cycle->code / 10);
	return cycle->repeats > 0 && axes;
}

bool canned_cycle_run(struct interp *interp)
{
	struct state *state = &interp->state;
	struct canned_cycle cycle = {.interp = interp,
				     .code = interp->block.motion,
				     .traits = traits_of(interp)->cycles,
				     .at = rotated_frame_straight(state)};
	int column = block_motion_column(&interp->block);
	bool kept, good;

	if (!dialect_answers_cycles(interp->config->dialect, &interp->at, column))
		return false;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		if (state->probe_bounded[slot] && !probed_axes_is_known(interp, slot, column))
			return false;
	}
	if (state->feed_mode == FEED_INVERSE_TIME)
		return fault(&interp->at, column, "G%g in inverse time mode (G93); write G94 or G95 first",
			     cycle.code / 10.0);
	if (state->cycle.known && cycle.traits->words_outlive_cycle == ANSWER_YES &&
	    (state->motion == CODE_NONE || !code_is_cycle(state->motion)))
		state->cycle.known = 0;
	if (!find_axes(&cycle))
		return false;
	kept = keeps_words(&cycle);
	if (!motion_commands_feed(interp, &cycle.feed) || !find_repeats(&cycle) || !cycle_heights_find(&cycle, kept) ||
	    !find_dwell(&cycle, kept) || !cycle_pecks_find(&cycle, kept) || !cycle_shift_find(&cycle, kept) ||
	    !check_spindle(&cycle) || !check_tap_plane(&cycle))
		return false;
	state->motion = cycle.code;
	return is_to_drill(&cycle, &good) ? make_cycle(&cycle) : good;
}
