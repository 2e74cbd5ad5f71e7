#include "gcode/execute/polar_interpolation.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/units.h"
#include "gcode/execute/polar_pieces.h"
#include "gcode/execute/probed_axes.h"

static bool check_start(struct interp *interp, int column)
{
	const struct state *state = &interp->state;
	const int rotary = interp->config->controller.polar_axis;

	if (!rotary)
		return fault(&interp->at, column,
			     "parameters 5460 and 5461 select the axes of G12.1: set polar_axes=\"XC\" (or \"XA\", "
			     "\"XB\") in the machine file's <controller>");
	if (!interp->config->has_axis[rotary] || !interp->config->has_axis[SLOT_X])
		return fault(&interp->at, column, "the machine has no X or no %c axis for G12.1", AXIS_LETTERS[rotary]);
	if (state->polar_interpolation.on)
		return fault(&interp->at, column, "G12.1 inside another G12.1; write G13.1 first");
	if (state->tcp != TCP_OFF || state->frame.on || state->polar.on || state->cylinder.on || state->dynamic.on)
		return fault(&interp->at, column,
			     "G12.1 in changed coordinates or under tool centre point control is not supported");
	return probed_axes_is_known(interp, SLOT_X, column) && probed_axes_is_known(interp, rotary, column);
}

static bool start(struct interp *interp, int column)
{
	struct state *state = &interp->state;
	struct polar_interpolation *polar = &state->polar_interpolation;
	const double x = state->position.v[SLOT_X] - state->offset.v[SLOT_X];

	if (!check_start(interp, column))
		return false;
	if (fabs(x) < POLAR_CENTRE)
		return fault(&interp->at, column,
			     "G12.1 must start with X away from 0, the centre of the rotary axis");
	*polar = (struct polar_interpolation){
	    .on = true,
	    .rotary = interp->config->controller.polar_axis,
	    .zero = {state->offset.v[SLOT_X], state->offset.v[SLOT_Y]},
	    .side = x < 0 ? -1 : 1,
	    .at = {x, 0},
	    .told = state->canonical,
	    .angle = state->canonical.v[interp->config->controller.polar_axis],
	    .y = state->position.v[SLOT_Y],
	    .plane = state->plane,
	    .unknown_plane = state->unknown_modes & 1U << G_PLANE,
	};
	state->plane = G17;
	state->unknown_modes &= ~(1U << G_PLANE);
	state_set_position(state, SLOT_Y, state->offset.v[SLOT_Y]);
	return true;
}

static void finish(struct interp *interp)
{
	struct state *state = &interp->state;
	struct polar_interpolation *polar = &state->polar_interpolation;

	if (!polar->on)
		return;
	polar->on = false;
	state->plane = polar->plane;
	state->unknown_modes |= polar->unknown_plane;
	state_set_position(state, SLOT_X,
			   polar->zero[0] + polar->side * math_hypot(polar->at[0], polar->at[1]));
	state_set_position(state, SLOT_Y, polar->y);
	state_set_position(state, polar->rotary, degrees(polar->angle));
}

bool polar_interpolation_switch(struct interp *interp)
{
	const struct block *block = &interp->block;
	int column = block->g_column[G_NONMODAL];

	if (block->letters & AXIS_BITS)
		return fault(&interp->at, column,
			     "G12.1 and G13.1 with axis words (shifted centre) are not supported");
	if (block->g[G_NONMODAL] == G12_1)
		return start(interp, column);
	finish(interp);
	return true;
}

/* The same section allows G1 to G3, G4, G9, G40 to G42, G90, G91, G94, G95 and macro calls. */
static bool check_codes(struct interp *interp)
{
	const struct block *block = &interp->block;
	const int groups[] = {G_PLANE,	G_LENGTH, G_SYSTEM,   G_ROTATION, G_MIRROR, G_SCALING,
			      G_POLAR, G_APPROACH, G_UNITS, G_DYNAMIC};
	int code = block->g[G_NONMODAL];

	for (size_t i = 0; i < sizeof(groups) / sizeof(groups[0]); i++) {
		if (block->g[groups[i]] != CODE_NONE)
			return fault(&interp->at, block->g_column[groups[i]],
				     "G%g under polar coordinate interpolation (G12.1); write G13.1 first",
				     block->g[groups[i]] / 10.0);
	}
	if (code != CODE_NONE && code != G4)
		return fault(&interp->at, block->g_column[G_NONMODAL],
			     "G%g under polar coordinate interpolation (G12.1); write G13.1 first", code / 10.0);
	if (block->m[M_TOOL] != CODE_NONE || block->m[M_TCP] != CODE_NONE || block_has(block, 'H') || block->corner)
		return fault(&interp->at, 1,
			     "a tool, its length or a corner with ,C or ,R under polar coordinate interpolation "
			     "(G12.1) is not supported");
	if (block->motion == CODE_NONE || (block->motion >= G1 && block->motion <= G3))
		return true;
	return fault(&interp->at, block_motion_column(block),
		     "G%g under polar coordinate interpolation (G12.1), which allows only feed moves",
		     block->motion / 10.0);
}

bool polar_interpolation_start_block(struct interp *interp)
{
	struct block *block = &interp->block;
	const char letter = AXIS_LETTERS[interp->state.polar_interpolation.rotary];

	if (!interp->state.polar_interpolation.on || block->g[G_NONMODAL] == G13_1 ||
	    block->g[G_NONMODAL] == G12_1)
		return true;
	if (!check_codes(interp))
		return false;
	if (block_has(block, 'Y'))
		return fault(&interp->at, block_column(block, 'Y'),
			     "Y under polar coordinate interpolation (G12.1) is not supported: %c is the second axis "
			     "of its plane",
			     letter);
	if (!block_has(block, letter))
		return true;
	block->letters = (block->letters & ~letter_bit(letter)) | letter_bit('Y');
	if (block->points & letter_bit(letter))
		block->points |= letter_bit('Y');
	block->value['Y' - 'A'] = block_value(block, letter);
	block->column['Y' - 'A'] = block_column(block, letter);
	return true;
}
