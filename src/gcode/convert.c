#include "gcode/convert.h"

#include "base/units.h"
#include "gcode/offsets.h"
#include "gcode/tooling.h"
#include "gcode/travel.h"

/* G93, G94, G95; then F, which inverse time mode gives to the motion of its own block only. */
static bool convert_feed(struct interp *interp)
{
	const struct block *block = &interp->block;
	struct state *state = &interp->state;
	enum feed_mode before = state->feed_mode;
	double feed;

	if (block->g[G_FEED_MODE] != CODE_NONE) {
		state->feed_mode = block->g[G_FEED_MODE] == G93   ? FEED_INVERSE_TIME
				   : block->g[G_FEED_MODE] == G94 ? FEED_PER_MINUTE
								  : FEED_PER_REVOLUTION;
		/* LinuxCNC forgets the feed with every G94 and G95, others where its unit changes. */
		if (interp->config->dialect == GCODE_LINUXCNC || state->feed_mode != before)
			state->feed_linear = state->feed_angular = 0;
	}
	if (!block_has(block, 'F'))
		return true;
	feed = block_value(block, 'F');
	if (feed < 0)
		return fault(&interp->at, block_column(block, 'F'), "a feed rate cannot be negative");
	if (state->feed_mode != FEED_INVERSE_TIME) {
		state->feed_linear = feed * state->scale;
		state->feed_angular = feed;
	}
	return true;
}

static bool convert_speed(struct interp *interp)
{
	const struct block *block = &interp->block;

	if (!block_has(block, 'S'))
		return true;
	if (block_value(block, 'S') < 0)
		return fault(&interp->at, block_column(block, 'S'), "a spindle speed cannot be negative");
	interp->state.speed = block_value(block, 'S');
	return true;
}

/* G61, G61.1: on the path; G64 may leave it, by P at most if P is given (LinuxCNC's manual, "G64"). */
static bool convert_path(struct interp *interp)
{
	const struct block *block = &interp->block;
	struct state *state = &interp->state;

	if (block->g[G_PATH] == CODE_NONE)
		return true;
	state->blend = block->g[G_PATH] == G64;
	state->blend_tolerance = 0;
	if (!state->blend || interp->config->dialect != GCODE_LINUXCNC || !block_has(block, 'P'))
		return true;
	if (block_value(block, 'P') < 0)
		return fault(&interp->at, block_column(block, 'P'), "a path tolerance cannot be negative");
	state->blend_tolerance = block_value(block, 'P') * state->scale;
	return true;
}

static void convert_modes(struct interp *interp)
{
	const struct block *block = &interp->block;
	struct state *state = &interp->state;

	if (block->g[G_DISTANCE] != CODE_NONE)
		state->incremental = block->g[G_DISTANCE] == G91;
	if (block->g[G_ARC_DISTANCE] != CODE_NONE)
		state->arc_absolute = block->g[G_ARC_DISTANCE] == G90_1;
}

static bool convert_nonmodal(struct interp *interp)
{
	switch (interp->block.g[G_NONMODAL]) {
	case G10:
		return offsets_set(interp);
	case G28:
	case G30:
		return travel_reference(interp);
	case G28_1:
	case G30_1:
		return travel_remember(interp);
	case G52:
	case G92:
	case G92_1:
	case G92_2:
	case G92_3:
		return offsets_shift(interp);
	default:
		return true;	/* G4 is done already, G53 belongs to the motion */
	}
}

/* LinuxCNC's manual, "Order of Execution"; NIST RS274/NGC, table 8. */
bool convert_block(struct interp *interp)
{
	const struct block *block = &interp->block;
	struct state *state = &interp->state;

	if (!convert_feed(interp) || !convert_speed(interp))
		return false;
	if (!tooling_select(interp) || !tooling_change(interp) || !tooling_mcode(interp))
		return false;
	if (block->g[G_NONMODAL] == G4 && !travel_dwell(interp))
		return false;
	if (block->g[G_PLANE] != CODE_NONE)
		state->plane = block->g[G_PLANE];
	if (block->g[G_UNITS] != CODE_NONE)
		state->scale = block->g[G_UNITS] == G20 ? MM_PER_INCH : 1;
	if (!tooling_length(interp) || !offsets_select(interp) || !convert_path(interp))
		return false;
	convert_modes(interp);
	if (!convert_nonmodal(interp) || !travel_motion(interp))
		return false;
	interp->ended = block->m[M_STOP] == 2 || block->m[M_STOP] == 30;
	return true;
}
