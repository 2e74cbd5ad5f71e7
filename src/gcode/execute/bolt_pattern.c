#include "gcode/execute/bolt_pattern.h"

#include "base/math/math_functions.h"
#include "gcode/execute/canned_cycle.h"
#include "gcode/execute/rotated_frame.h"

#define HOLES_MAX 9999

static bool check_allowed(struct interp *interp)
{
	const struct state *state = &interp->state;
	const struct block *block = &interp->block;
	int column = block->g_column[G_NONMODAL], code = block->g[G_NONMODAL] / 10;

	if (block->g[G_MOTION] != CODE_NONE)
		return fault(&interp->at, column,
			     "G%d beside a cycle, G80 or a motion code is not supported, because their order is not "
			     "known; write separate blocks",
			     code);
	if (state->motion == CODE_NONE || !code_is_cycle(state->motion))
		return fault(&interp->at, column, "G%d needs an active canned cycle that makes the holes", code);
	if (block->letters & AXIS_BITS)
		return fault(&interp->at, column,
			     "G%d needs a block without axis words: its centre is the present position", code);
	if (state->plane != G17 || state->incremental || state->polar.on)
		return fault(&interp->at, column,
			     "G%d is supported only in the plane of G17, with G90 and without G16", code);
	if (!block_has(block, 'I') || !(block_value(block, 'I') > 0))
		return fault(&interp->at, column, "G%d needs I (radius of the circle), greater than 0", code);
	if (!block_has(block, 'J') || !block_has(block, 'L'))
		return fault(&interp->at, column, "G%d needs J (angle of the first hole) and L (number of holes)",
			     code);
	if (block_has(block, 'K') != (code == 71))
		return fault(&interp->at, column,
			     code == 71 ? "G71 needs K (angle between holes)" : "K does not belong to G70");
	return true;
}

/*
 * Haas mill operator's manual, "G70 Bolt Hole Circle" and "G71 Bolt Hole Arc": I is the radius, J the angle of the
 * first hole, counter-clockwise from three o'clock, L the number of holes; G70 spaces them evenly, G71 by K.
 */
bool bolt_pattern_run(struct interp *interp)
{
	const struct block pattern = interp->block;
	struct block *block = &interp->block;
	const struct state *state = &interp->state;
	const slot_values centre = rotated_frame_straight(state);
	double radius, step;
	int holes = 0;
	bool good = true;

	if (!check_allowed(interp) || !block_integer(block, &interp->at, 'L', 1, HOLES_MAX, &holes))
		return false;
	radius = block_value(&pattern, 'I') * state->scale;
	step = pattern.g[G_NONMODAL] == G71 ? block_value(&pattern, 'K') : 360.0 / holes;
	block->letters = (pattern.letters & letter_bit('F')) | letter_bit('X') | letter_bit('Y');
	block->motion = state->motion;
	for (int i = 0; i < holes && good; i++) {
		double angle = block_value(&pattern, 'J') + i * step;
		double x = centre.v[SLOT_X] + radius * math_cos_degrees(angle) - state->offset.v[SLOT_X];
		double y = centre.v[SLOT_Y] + radius * math_sin_degrees(angle) - state->offset.v[SLOT_Y];

		block->value['X' - 'A'] = x / state->scale;
		block->value['Y' - 'A'] = y / state->scale;
		good = canned_cycle_run(interp);
	}
	*block = pattern;
	return good;
}
