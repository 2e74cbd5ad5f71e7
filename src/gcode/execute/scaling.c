#include "gcode/execute/scaling.h"

#include "base/same_double.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"
#include "gcode/execute/rotated_frame.h"

static bool refuse(struct interp *interp, int column, const char *what)
{
	return fault(&interp->at, column,
		     "%s while coordinates are scaled (G51) is not supported; write G50 first", what);
}

/* Both manuals: pecks, shifts of bores and the radius of compensation are not scaled. */
static bool check_cycle(struct interp *interp)
{
	int code = interp->block.motion;

	if (code == G73 || code == G76 || code == G77 || code == G83 || code == G87)
		return refuse(interp, block_motion_column(&interp->block), "a cycle with pecks or a shift");
	return true;
}

bool scaling_start_block(struct interp *interp)
{
	const struct block *block = &interp->block;
	int code = block->g[G_NONMODAL], column;
	const char *what;

	if (code != CODE_NONE && code != G4)
		return refuse(interp, block->g_column[G_NONMODAL],
			      "a change of offsets or a move to a machine position");
	what = rotated_frame_conflict(block, &column);
	if (what)
		return refuse(interp, column, what);
	if (block->g[G_MIRROR] != CODE_NONE)
		return refuse(interp, block->g_column[G_MIRROR], "a mirror image");
	if (block->g[G_CUTTER] != CODE_NONE && block->g[G_CUTTER] != G40)
		return refuse(interp, block->g_column[G_CUTTER], "cutter compensation");
	if (block->corner)
		return refuse(interp, block->corner_column, "a corner with ,C or ,R");
	return check_cycle(interp);
}

/* One factor for all axes: P, or equal I, J and K. Then arcs stay arcs. */
static bool find_factor(struct interp *interp, double *factor)
{
	const struct block *block = &interp->block;
	int column = block->g_column[G_SCALING];
	char first = block_has(block, 'P') ? 'P' : 'I';

	for (const char *letter = first == 'P' ? "P" : "IJK"; *letter; letter++) {
		if (!block_has(block, *letter))
			return fault(&interp->at, column,
				     "G51 needs P (factor), or I, J and K; otherwise a parameter of the control gives "
				     "the factor");
		if (!(block->points & letter_bit(*letter)))
			return fault(&interp->at, block_column(block, *letter),
				     "%c of G51 without a decimal point: a parameter of the control decides whether it "
				     "is in thousandths; write a decimal point",
				     *letter);
		if (!same_double(block_value(block, *letter), block_value(block, first)))
			return fault(&interp->at, block_column(block, *letter),
				     "G51 with different factors for the axes is not supported");
	}
	*factor = block_value(block, first);
	return *factor > 0 ||
	       fault(&interp->at, block_column(block, first), "the factor of G51 must be greater than 0");
}

/* The centre of an axis without a word is its present position. */
static bool find_centre(struct interp *interp, double centre[3])
{
	const struct block *block = &interp->block;
	const struct state *state = &interp->state;

	for (int slot = SLOT_X; slot < SLOT_COUNT; slot++) {
		char letter = AXIS_LETTERS[slot];
		bool given = block_has(block, letter);

		if (given && slot > SLOT_Z)
			return fault(&interp->at, block_column(block, letter), "%c with G51 is not supported", letter);
		if (slot <= SLOT_Z)
			centre[slot] = given ? block_value(block, letter) * state->scale
					     : state->position.v[slot] - state->offset.v[slot];
	}
	return true;
}

static bool start(struct interp *interp)
{
	struct state *state = &interp->state;
	int column = interp->block.g_column[G_SCALING];
	slot_values before = state->position;
	double factor = 1, centre[3] = {0};

	if (state->frame.on || state->tcp != TCP_OFF || cutter_comp_is_on(interp))
		return fault(&interp->at, column,
			     "G51 is not supported in rotated, mirrored or scaled coordinates, under tool centre point "
			     "control or under cutter compensation");
	if (state->incremental)
		return fault(&interp->at, column, "G51 in incremental mode (G91) is not supported; write G90 first");
	if (!find_factor(interp, &factor) || !find_centre(interp, centre))
		return false;
	state->frame = (struct rotated_frame){.on = true,
					      .distorts = true,
					      .scales = true,
					      .growth = factor,
					      .turn = {{factor, 0, 0}, {0, factor, 0}, {0, 0, factor}},
					      .back = {{1 / factor, 0, 0}, {0, 1 / factor, 0}, {0, 0, 1 / factor}},
					      .origin = {(1 - factor) * centre[0], (1 - factor) * centre[1],
							 (1 - factor) * centre[2]}};
	state->cycle.turned = true;
	rotated_frame_mark_unsure(state, &before, G51);
	return true;
}

bool scaling_switch(struct interp *interp)
{
	struct state *state = &interp->state;
	slot_values before;

	if (interp->block.g[G_SCALING] == G51)
		return start(interp);
	if (interp->block.g[G_SCALING] == CODE_NONE || !state->frame.scales)
		return true;
	before = rotated_frame_straight(state);
	state->frame = (struct rotated_frame){0};
	state->cycle.turned = true;
	rotated_frame_mark_unsure(state, &before, G50);
	return true;
}
