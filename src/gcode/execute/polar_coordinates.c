#include "gcode/execute/polar_coordinates.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/same_double.h"
#include "base/units.h"
#include "geom/tolerance.h"

static int slot_of_radius(const struct state *state)
{
	return state->plane == G17 ? SLOT_X : state->plane == G18 ? SLOT_Z : SLOT_Y;
}

static int slot_of_angle(const struct state *state)
{
	return state->plane == G17 ? SLOT_Y : state->plane == G18 ? SLOT_X : SLOT_Z;
}

bool polar_coordinates_switch(struct interp *interp)
{
	const struct block *block = &interp->block;
	int code = block->g[G_POLAR];

	/* In another plane other words are the radius and the angle. */
	if (block->g[G_PLANE] != CODE_NONE && code == CODE_NONE)
		interp->state.polar = (struct polar_coordinates){.on = interp->state.polar.on};
	if (code != CODE_NONE)
		interp->state.polar = (struct polar_coordinates){.on = code == G16};
	return true;
}

bool polar_coordinates_take(const struct interp *interp, int slot)
{
	const struct state *state = &interp->state;

	return state->polar.on && (slot == slot_of_radius(state) || slot == slot_of_angle(state));
}

bool polar_coordinates_is_angle(const struct interp *interp, char letter)
{
	int code = interp->block.g[G_POLAR];
	bool on = code == G16 || (interp->state.polar.on && code == CODE_NONE);

	return on && interp->block.g[G_NONMODAL] == CODE_NONE && interp->block.g[G_ROTATION] == CODE_NONE &&
	       letter == AXIS_LETTERS[slot_of_angle(&interp->state)];
}

/*
 * An absolute radius starts at the zero of the work offset. An increment, also of 0, makes the position of the tool the
 * pole (Fanuc B-62764EN, 9.2: "G91 specifies the current position as the origin of the polar coordinate system").
 */
static bool take_words(struct interp *interp, char radius, char angle)
{
	const struct block *block = &interp->block;
	struct state *state = &interp->state;
	struct polar_coordinates *polar = &state->polar;

	if (block_has(block, radius)) {
		if (state->incremental)
			return fault(&interp->at, block_column(block, radius),
				     "increment in %c (G91) in polar coordinates (G16) is not supported: it moves the "
				     "pole to the tool position",
				     radius);
		polar->radius = block_value(block, radius) * state->scale;
		polar->has_radius = true;
	}
	if (block_has(block, angle)) {
		if (state->incremental && !polar->has_angle)
			return fault(&interp->at, block_column(block, angle),
				     "increment in %c (G91) before any angle in polar coordinates (G16)",
				     angle);
		polar->angle = block_value(block, angle) + (state->incremental ? polar->angle : 0);
		polar->has_angle = true;
	}
	return true;
}

bool polar_coordinates_find(struct interp *interp, slot_values *target)
{
	struct state *state = &interp->state;
	struct polar_coordinates *polar = &state->polar;
	int a = slot_of_radius(state), b = slot_of_angle(state);
	char radius = AXIS_LETTERS[a], angle = AXIS_LETTERS[b];

	if (!(interp->block.letters & (letter_bit(radius) | letter_bit(angle))))
		return true;
	if (!take_words(interp, radius, angle))
		return false;
	if (!polar->has_radius || !polar->has_angle)
		return fault(
		    &interp->at, block_motion_column(&interp->block),
		    "the first move in polar coordinates (G16) needs %c (radius) and %c (angle)", radius,
		    angle);
	target->v[a] = state->offset.v[a] + polar->radius * math_cos_degrees(polar->angle);
	target->v[b] = state->offset.v[b] + polar->radius * math_sin_degrees(polar->angle);
	state->settles[a] = state->settles[b] = true;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		state->probed[slot] =
		    state->probed[slot] && (state->probe_bounded[slot] || !polar_coordinates_take(interp, slot));
	return true;
}

/* Is the place known from which @ and ^ count? False: reported. */
static bool check_start(struct interp *interp, double radius, int column)
{
	const struct state *state = &interp->state;
	const uint32_t given = interp->block.polar;

	if (interp->comp.side != 0)
		return fault(&interp->at, column,
			     "polar coordinates (@, ^) under cutter compensation are not supported; write X and Y");
	if (state->probed[SLOT_X] || state->probed[SLOT_Y])
		return fault(&interp->at, column,
			     "polar coordinates (@, ^) where a probe may have stopped anywhere are not supported; "
			     "write X and Y");
	if (radius > SAME_POINT || (!state->incremental && given & letter_bit('Y')))
		return true;
	return fault(&interp->at, column,
		     state->incremental ? "increments of polar coordinates (@, ^) where the tool stands at X0 Y0"
					: "@ needs ^ beside it where the tool stands at X0 Y0");
}

bool polar_coordinates_words(struct interp *interp, slot_values *target)
{
	const struct block *block = &interp->block;
	struct state *state = &interp->state;
	const int column = block->polar & letter_bit('X') ? block_column(block, 'X') : block_column(block, 'Y');
	const double x = target->v[SLOT_X] - state->offset.v[SLOT_X];
	const double y = target->v[SLOT_Y] - state->offset.v[SLOT_Y];
	double radius = sqrt(x * x + y * y), angle = math_atan2_degrees(y, x);

	if (!check_start(interp, radius, column))
		return false;
	if (block->polar & letter_bit('X'))
		radius = block_value(block, 'X') * state->scale + (state->incremental ? radius : 0);
	if (block->polar & letter_bit('Y'))
		angle = block_value(block, 'Y') + (state->incremental ? angle : 0);
	target->v[SLOT_X] = state->offset.v[SLOT_X] + radius * math_cos_degrees(angle);
	target->v[SLOT_Y] = state->offset.v[SLOT_Y] + radius * math_sin_degrees(angle);
	return true;
}
