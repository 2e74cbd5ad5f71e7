#include "gcode/execute/coordinate_conversion.h"

#include "base/same_double.h"
#include "base/units.h"
#include "gcode/execute/rotated_frame.h"
#include "geom/tolerance.h"

/* Further conversions are an alarm. */
#define CONVERSIONS_MAX 2

bool coordinate_conversion_is(const struct block *block)
{
	return block->g[G_ROTATION] == G68 && (block->letters & (letter_bit('I') | letter_bit('J') | letter_bit('K')));
}

bool coordinate_conversion_goes_on(const struct interp *interp)
{
	const int before = interp->state.frame.conversions;

	return coordinate_conversion_is(&interp->block) && before > 0 && before < CONVERSIONS_MAX;
}

static vec3 words(const struct block *block, const char letters[3], double scale)
{
	double value[3];

	for (int i = 0; i < 3; i++)
		value[i] = block_has(block, letters[i]) ? block_value(block, letters[i]) * scale : 0;
	return (vec3){value[0], value[1], value[2]};
}

static bool check_form(struct interp *interp)
{
	const struct block *block = &interp->block;
	const int column = block->g_column[G_ROTATION];
	int centre = 0;

	for (int slot = SLOT_X; slot < SLOT_COUNT; slot++) {
		bool given = block_has(block, AXIS_LETTERS[slot]);

		if (given && slot > SLOT_Z)
			return fault(&interp->at, block_column(block, AXIS_LETTERS[slot]),
				     "%c does not belong to G68 with I, J and K, whose centre is given by X, Y and Z",
				     AXIS_LETTERS[slot]);
		centre += given;
	}
	if (!block_has(block, 'I') || !block_has(block, 'J') || !block_has(block, 'K') || !block_has(block, 'R'))
		return fault(&interp->at, column, "G68 with I, J or K needs all three of them, and R (angle)");
	if (centre == 3 || (centre == 0 && interp->state.frame.conversions > 0))
		return true;
	return fault(&interp->at, column, "G68 with I, J and K needs X, Y and Z (centre)");
}

/*
 * Fanuc 16-C operator's manual (B-62764EN), "Three-dimensional coordinate conversion": the zero is moved to the centre,
 * and the axes turn by R about the direction I J K through the centre. A second G68 is given in the coordinates of the
 * first one; without a centre it turns about the same point.
 */
bool coordinate_conversion_turn(struct interp *interp)
{
	struct state *state = &interp->state;
	const struct block *block = &interp->block;
	const slot_values before = rotated_frame_straight(state);
	struct rotated_frame frame = {.on = true, .conversions = state->frame.conversions + 1};
	const vec3 axis = words(block, "IJK", 1), centre = words(block, "XYZ", state->scale);
	const double length = vec3_norm(axis);

	if (!check_form(interp))
		return false;
	if (!(length > 0))
		return fault(&interp->at, block->g_column[G_ROTATION], "I, J and K of G68 are all 0");
	frame.turn = mat3_turn(vec3_scale(1 / length, axis), radians(block_value(block, 'R')));
	frame.origin = centre;
	if (frame.conversions > 1) {
		frame.origin = vec3_add(state->frame.origin, mat3_apply(&state->frame.turn, centre));
		frame.turn = mat3_mul(&state->frame.turn, &frame.turn);
	}
	frame.turns_length = interp->config->controller.length_under_g68 == LENGTH_UNDER_G68_TURNED;
	state->frame = frame;
	rotated_frame_mark_unsure(state, &before, G68);
	return coordinate_conversion_knows_length(interp, block->g_column[G_ROTATION], state->length);
}

bool coordinate_conversion_knows_length(const struct interp *interp, int column, double length)
{
	if (interp->state.frame.conversions == 0 || same_double(length, 0) ||
	    interp->config->controller.length_under_g68 != LENGTH_UNDER_G68_UNKNOWN)
		return true;
	return fault(&interp->at, column,
		     "controls differ in the direction in which the tool length acts while G68 with I, J and K is "
		     "active: set length_under_g68=\"turned\" (rotated Z) or \"straight\" (Z of the machine) in the "
		     "machine file's <controller>");
}

bool coordinate_conversion_check_words(const struct interp *interp, bool absolute)
{
	const struct state *state = &interp->state;
	const struct block *block = &interp->block;
	const uint32_t linear = letter_bit('X') | letter_bit('Y') | letter_bit('Z');

	if (state->frame.conversions == 0 || !(block->letters & linear))
		return true;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		if (state->unsure[slot] && (!absolute || !block_has(block, AXIS_LETTERS[slot])))
			return fault(&interp->at, block_motion_column(block),
				     "the first move after G68 with I, J and K needs X, Y and Z as absolute "
				     "coordinates, because controls differ in where %c stays",
				     AXIS_LETTERS[slot]);
	}
	return true;
}
