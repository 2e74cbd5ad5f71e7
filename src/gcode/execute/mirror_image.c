#include "gcode/execute/mirror_image.h"

#include "base/same_double.h"
#include "gcode/execute/rotated_frame.h"

static bool refuse(struct interp *interp, int column, const char *what)
{
	return fault(&interp->at, column,
		     "%s while a mirror image is active is not supported; cancel the mirror image first",
		     what);
}

static bool is_mirrored(const struct state *state, int slot)
{
	const mat3 *turn = &state->frame.turn;

	return (slot == SLOT_X ? turn->x.x : slot == SLOT_Y ? turn->y.y : turn->z.z) < 0;
}

/* G28, G30, G53: refused, or refused only for a mirrored axis. */
static bool check_by_machine(struct interp *interp)
{
	const struct block *block = &interp->block;
	bool all = !(block->letters & AXIS_BITS);

	if (traits_of(interp)->turned_by_machine != TURNED_BY_MACHINE_ACROSS)
		return false;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		if (is_mirrored(&interp->state, slot) && (all || block_has(block, AXIS_LETTERS[slot])))
			return false;
	}
	return true;
}

static bool check_cycle(struct interp *interp)
{
	const struct block *block = &interp->block;
	int plane = block->g[G_PLANE] == CODE_NONE ? interp->state.plane : block->g[G_PLANE];
	int depth = plane == G17 ? SLOT_Z : plane == G18 ? SLOT_Y : SLOT_X;

	if (block->motion == CODE_NONE || !code_is_cycle(block->motion))
		return true;
	if (is_mirrored(&interp->state, depth))
		return refuse(interp, block_motion_column(block), "a canned cycle along a mirrored axis");
	if (block->motion != G83 && block->motion != G73 && (block->letters & (letter_bit('I') | letter_bit('J'))))
		return refuse(interp, block_motion_column(block), "a shift by I and J");
	return true;
}

bool mirror_image_start_block(struct interp *interp)
{
	const struct block *block = &interp->block;
	int code = block->g[G_NONMODAL], column;
	const char *what;

	if (code == G10 || code == G52 || code == G92 || code == G92_1)
		return refuse(interp, block->g_column[G_NONMODAL], "a change of offsets");
	what = rotated_frame_conflict(block, &column);
	if (what)
		return refuse(interp, column, what);
	if (block->g[G_SCALING] == G51)
		return refuse(interp, block->g_column[G_SCALING], "scaling");
	if ((code == G28 || code == G30 || code == G53) && !check_by_machine(interp))
		return refuse(interp, block->g_column[G_NONMODAL], "a move to a machine position");
	return check_cycle(interp);
}

/* Adds the mirror of each axis, at a coordinate on controls that have one. */
static bool add_mirrors(struct interp *interp, double sign[3], double at[3])
{
	const struct block *block = &interp->block;
	const struct state *state = &interp->state;
	int column = block->g_column[G_MIRROR], code = block->g[G_MIRROR];
	bool any = false;

	if (state->incremental)
		return fault(&interp->at, column, "G%g in incremental mode (G91) is not supported; write G90 first",
			     code / 10.0);
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		char letter = AXIS_LETTERS[slot];

		if (!block_has(block, letter))
			continue;
		if (slot > SLOT_Z)
			return fault(&interp->at, block_column(block, letter), "a mirror image of %c is not supported",
				     letter);
		/* Haas mirrors at the zero of the work offset; its manual does not explain other values. */
		if (code == G101 && !same_double(block_value(block, letter), 0))
			return fault(&interp->at, block_column(block, letter),
				     "G101 with a value other than 0 is not supported");
		any = true;
		sign[slot] = -1;
		at[slot] = block_value(block, letter) * state->scale;
	}
	return any || fault(&interp->at, column, "G%g needs words for the axes to mirror", code / 10.0);
}

bool mirror_image_switch(struct interp *interp)
{
	struct state *state = &interp->state;
	const struct block *block = &interp->block;
	const mat3 *turn = &state->frame.turn;
	const vec3 *origin = &state->frame.origin;
	bool was_on = state->frame.on && state->frame.distorts,
	     ends = block->g[G_MIRROR] == G50_1 || block->g[G_MIRROR] == G100;
	double sign[3] = {1, 1, 1}, at[3] = {0};
	slot_values before;

	if (block->g[G_MIRROR] == CODE_NONE || (ends && !was_on))
		return true;
	before = rotated_frame_straight(state);
	if ((state->frame.on && !was_on) || state->tcp != TCP_OFF)
		return fault(
		    &interp->at, block->g_column[G_MIRROR],
		    "a mirror image of rotated coordinates, or under tool centre point control, is not supported");
	if (was_on) {
		sign[0] = turn->x.x, sign[1] = turn->y.y, sign[2] = turn->z.z;
		at[0] = origin->x / 2, at[1] = origin->y / 2, at[2] = origin->z / 2;
	}
	if (!ends && !add_mirrors(interp, sign, at))
		return false;
	for (int slot = SLOT_X; slot <= SLOT_Z && ends; slot++) {
		if (!(block->letters & AXIS_BITS) || block_has(block, AXIS_LETTERS[slot]))
			sign[slot] = 1;
	}
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		at[slot] = sign[slot] < 0 ? 2 * at[slot] : 0;
	state->frame = (struct rotated_frame){.on = sign[0] < 0 || sign[1] < 0 || sign[2] < 0,
					      .distorts = true,
					      .growth = 1,
					      .mirrors = sign[0] * sign[1] * sign[2] < 0,
					      .turn = {{sign[0], 0, 0}, {0, sign[1], 0}, {0, 0, sign[2]}},
					      .origin = {at[0], at[1], at[2]}};
	state->frame.back = state->frame.turn;
	if (!state->frame.on)
		state->frame = (struct rotated_frame){0};
	state->cycle.turned = true;
	if (ends)
		rotated_frame_mark_unsure(state, &before, block->g[G_MIRROR]);
	return true;
}
