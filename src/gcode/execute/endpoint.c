#include "gcode/execute/endpoint.h"

#include <math.h>
#include <string.h>

#include "base/same_double.h"
#include "gcode/execute/coordinate_rotation.h"
#include "gcode/execute/dynamic_work_offset.h"
#include "gcode/execute/polar_coordinates.h"
#include "gcode/execute/probed_axes.h"
#include "gcode/execute/rotated_frame.h"
#include "gcode/execute/tool_length.h"
#include "geom/tolerance.h"

/*
 * The shortest path to a position modulo a turn (Fanuc 16i/18i-MB operator's manual, B-63534EN, "Rotary axis
 * roll-over"). The manual does not give the direction of exactly half a turn.
 */
static bool shortest(struct interp *interp, int slot, double aim, int column, double *target)
{
	double here = interp->state.position.v[slot];
	double way = remainder(aim - here, 360);
	int half_turn = interp->config->half_turn[slot];

	if (fabs(way) >= 180 - SAME_DEGREES) {
		if (!half_turn)
			return fault(&interp->at, column,
				     "half a turn of %c is equally short in both directions: set "
				     "half_turn=\"positive\" or \"negative\" for this axis in the machine file",
				     AXIS_LETTERS[slot]);
		way = half_turn * fabs(way);
	}
	*target = aim + 360 * round((here + way - aim) / 360);
	return true;
}

/* The sign of the word is the direction (LinuxCNC's manual, "WRAPPED_ROTARY"); the turn is less than 360 degrees. */
static double directed(const struct interp *interp, int slot, double aim, bool negative)
{
	double turns = (interp->state.position.v[slot] - aim) / 360;

	if (negative)
		return aim + 360 * floor(turns + SAME_DEGREES / 360);
	return aim + 360 * ceil(turns - SAME_DEGREES / 360);
}

/* Does an absolute position stand for all positions modulo a turn? */
static bool turns_round(const struct interp *interp, int slot)
{
	return slot_is_rotary(slot) && interp->config->wrap[slot] != WRAP_NONE;
}

bool endpoint_absolute(struct interp *interp, int slot, double value, double origin, int column, double *target)
{
	const struct gcode_config *config = interp->config;

	if (!turns_round(interp, slot)) {
		*target = value + origin;
		return true;
	}
	if (config->wrap[slot] == WRAP_SHORTEST)
		return shortest(interp, slot, value + origin, column, target);
	if (fabs(value) >= 360 && !is_answered(interp, column, traits_of(interp)->wrap_below_turn,
					       "where an absolute position of a turn or more moves a wrapped axis"))
		return false;
	if (fabs(value) >= 360 && traits_of(interp)->wrap_below_turn == ANSWER_YES)
		return fault(&interp->at, column,
			     "%c%.15g: the absolute position of a wrapped axis must be between -360 and 360 degrees",
			     AXIS_LETTERS[slot], value);
	*target = directed(interp, slot, fabs(value) + origin, signbit(value));
	return true;
}

/*
 * If the set of places after a probe is not followed (probed_axes.h), the program must move the probed axes back along
 * the probe's path before it moves other axes. Otherwise the path depends on where the probe has stopped, while the
 * checked path starts at the end of the probe's path.
 */
static void caution_probe(struct interp *interp)
{
	bool unknown = false, others = false;

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		unknown |= interp->state.probed[slot] && !interp->state.probe_bounded[slot];
		others |= !interp->state.probed[slot] && block_has(&interp->block, AXIS_LETTERS[slot]);
	}
	if (!unknown || !others || interp->cautioned_probe)
		return;
	interp->cautioned_probe = true;
	caution(&interp->at, block_motion_column(&interp->block),
		"this path depends on where the probe stopped; under TCP, in rotated coordinates, with cutter "
		"compensation and for rotary axes, only the path from the end point of the probing move is checked, "
		"here and further on; move the probed axis to an absolute coordinate in a block of its own first");
}

/* An absolute word makes the position of a probed axis known, unless its interval is followed (probed_axes.h). */
static void settle(struct interp *interp, int slot)
{
	struct state *state = &interp->state;
	const int motion = interp->block.motion;

	state->settles[slot] = !state->incremental;
	if (!state->incremental && motion >= G0 && motion <= G3 && !state->probe_bounded[slot])
		state->probed[slot] = false;
}

static void forget_sets(struct interp *interp)
{
	probed_axes_forget_turned(&interp->state);
	for (int slot = 0; slot < SLOT_COUNT && interp->comp.side != 0; slot++)
		interp->state.probe_bounded[slot] = false;
}

/* Is the end position of the axis for this word known? False: reported. */
static bool is_certain(struct interp *interp, int slot, double value)
{
	const struct state *state = &interp->state;
	const bool moves = !state->incremental || !same_double(value, 0);
	const int column = block_column(&interp->block, AXIS_LETTERS[slot]);

	if (moves && state->length_doubt != CODE_NONE && tool_length_is_in_doubt(interp, slot, column))
		return false;
	return !moves || !state->incremental || state->probe_bounded[slot] ||
	       probed_axes_is_known(interp, slot, column);
}

bool endpoint_find(struct interp *interp, bool machine, slot_values *target)
{
	static const bool none[SLOT_COUNT];
	const struct block *block = &interp->block;
	struct state *state = &interp->state;
	const bool polar = !machine && state->polar.on, incremental = state->incremental;
	const bool in_doubt = !machine && (incremental || state->length_doubt != CODE_NONE);
	/* A fast test: in most programs no probe ever stops an axis. */
	const bool probed = memcmp(state->probed, none, sizeof(none)) != 0;
	/* Nearly all blocks: each word alone gives the position of its axis. */
	const bool usual = !polar && !block->polar && !incremental && !in_doubt && !probed;
	uint32_t left = block->letters & AXIS_BITS;

	*target = state->frame.on ? rotated_frame_straight(state) : state->position;
	if (!left)
		return true;
	if (state->frame.on && state->frame.waits_for_tool)
		return fault(&interp->at, block_motion_column(block),
			     "a move between G68.2 and G53.1 is not supported, because the tool does not yet stand on "
			     "the plane");
	if ((state->unsure_code != CODE_NONE && !coordinate_rotation_check_words(interp, machine)) ||
	    (state->dynamic.unsure_code != CODE_NONE && !dynamic_work_offset_check_words(interp)))
		return false;
	forget_sets(interp);
	if (probed)
		caution_probe(interp);
	for (int slot = SLOT_X; slot <= SLOT_Z && state->length_moves && !machine; slot++)
		target->v[slot] += state->length_shift.v[slot];
	for (int slot = 0; left; slot++) {
		const char letter = AXIS_LETTERS[slot];
		double origin, value;

		if (!(left & letter_bit(letter)))
			continue;
		left &= ~letter_bit(letter);
		origin = machine ? 0 : state->offset.v[slot];
		value = block_value(block, letter) * (slot_is_rotary(slot) ? 1 : state->scale);
		if (usual && !turns_round(interp, slot)) {
			target->v[slot] = value + origin;
			continue;
		}
		if ((polar && polar_coordinates_take(interp, slot)) || block->polar & letter_bit(letter))
			continue;
		if (in_doubt && !is_certain(interp, slot, value))
			return false;
		if (incremental)
			target->v[slot] += value;
		else if (!endpoint_absolute(interp, slot, value, origin, block_column(block, letter),
					    &target->v[slot]))
			return false;
		if (probed)
			settle(interp, slot);
	}
	if (interp->lost && !incremental)
		interp->lost &= ~block->letters;
	if (block->polar && !polar_coordinates_words(interp, target))
		return false;
	return machine || !state->polar.on || polar_coordinates_find(interp, target);
}
