#include "gcode/execute/pocket_milling.h"

#include <math.h>

#include "gcode/execute/motion_commands.h"
#include "gcode/execute/parallel_moves.h"
#include "gcode/execute/pocket_outline.h"
#include "gcode/execute/probed_axes.h"
#include "gcode/execute/tool_table.h"

static bool refuse(struct interp *interp, const char *why)
{
	return fault(&interp->at, interp->block.g_column[G_NONMODAL], "G150 %s", why);
}

/* ------------------------------------------------------------ the blocks */

static bool check_outline_block(struct interp *interp)
{
	const struct block *block = &interp->block;
	bool moves = block->motion >= G1 && block->motion <= G3, ends = block->m[M_STOP] == 99;

	for (int group = 0; group < G_GROUPS; group++) {
		if (block->g[group] != CODE_NONE && group != G_MOTION && group != G_DISTANCE && group != G_PATH)
			return fault(&interp->at, block->g_column[group],
				     "G%g in the outline of a G150 pocket, which can have only G1, G2 and G3",
				     block->g[group] / 10.0);
	}
	if (block->m_count > ends || (ends && block_has(block, 'P')) || block->corner ||
	    (block->motion != CODE_NONE && !moves) || (block->letters & AXIS_BITS & ~letter_bits("XY")))
		return fault(&interp->at, 1,
			     "the outline of a G150 pocket must consist of moves of X and Y by G1, G2 and G3, up to "
			     "M99");
	return true;
}

/* In turned, mirrored or scaled coordinates a word does not determine the position of one machine axis. */
static bool changes_coordinates(const struct block *block)
{
	static const int groups[] = {G_ROTATION, G_MIRROR, G_SCALING, G_POLAR, G_DYNAMIC, G_LENGTH};
	static const int harmless[] = {G69, G50, G50_1, G100, G15, G255, G43, G49};

	for (size_t i = 0; i < sizeof(groups) / sizeof(groups[0]); i++) {
		bool known = block->g[groups[i]] == CODE_NONE;

		for (size_t k = 0; k < sizeof(harmless) / sizeof(harmless[0]); k++)
			known |= block->g[groups[i]] == harmless[k];
		if (!known)
			return true;
	}
	return false;
}

/* The tool is somewhere in the pocket, and G41 of G150 may still be on. */
static bool check_block_behind(struct interp *interp)
{
	struct pocket_milling *pocket = &interp->state.pocket_milling;
	const struct block *block = &interp->block;
	bool incremental = block->g[G_DISTANCE] == CODE_NONE ? interp->state.incremental : block->g[G_DISTANCE] == G91;

	if (block->g[G_CUTTER] == G40)
		pocket->compensated = false;
	if (changes_coordinates(block))
		return fault(&interp->at, 1,
			     "the position of the tool in the G150 pocket is not known: move to absolute X, Y and Z by "
			     "G0 or G1 before the coordinates change");
	if (block->words == 0 || (block->motion == CODE_NONE && block->g[G_NONMODAL] == CODE_NONE &&
				  block->m[M_TOOL] == CODE_NONE))
		return true;
	if (pocket->compensated)
		return fault(&interp->at, 1, "the cutter compensation of G150 is still on; write G40 first");
	if (block->motion > G1 || block->g[G_NONMODAL] != CODE_NONE || block->m[M_TOOL] != CODE_NONE || incremental ||
	    (block->letters & AXIS_BITS & ~letter_bits("XYZ")))
		return fault(&interp->at, 1,
			     "the position of the tool in the G150 pocket is not known: move to absolute X, Y and Z by "
			     "G0 or G1 first");
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		pocket->open[slot] = pocket->open[slot] && !block_has(block, AXIS_LETTERS[slot]);
	return true;
}

bool pocket_milling_start_block(struct interp *interp)
{
	struct pocket_milling *pocket = &interp->state.pocket_milling;
	struct block *block = &interp->block;

	if (pocket->takes) {
		pocket->takes = check_outline_block(interp);
		return pocket->takes;
	}
	if ((pocket->compensated || pocket->open[0] || pocket->open[1] || pocket->open[2]) &&
	    !check_block_behind(interp))
		return false;
	if (block->g[G_NONMODAL] != G150)
		return true;
	pocket->side = block->g[G_CUTTER] == G41 ? 1 : block->g[G_CUTTER] == G42 ? -1 : 0;
	pocket->compensated = pocket->side != 0;
	block->g[G_CUTTER] = CODE_NONE;
	return true;
}

/* -------------------------------------------------------------- its words */

static bool check_state(struct interp *interp)
{
	const struct state *state = &interp->state;
	const int column = interp->block.g_column[G_NONMODAL];

	if (state->plane != G17 || state->incremental)
		return refuse(interp, "needs the plane of G17 and G90");
	if (state->frame.on || state->tcp != TCP_OFF || state->polar.on || interp->comp.side != 0 || state->dynamic.on)
		return refuse(interp,
			      "is not supported in changed coordinates, under tool centre point control or under "
			      "cutter compensation");
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		if (!probed_axes_is_known(interp, slot, column))
			return false;
	}
	return true;
}

static bool check_words(struct interp *interp)
{
	const struct block *block = &interp->block;

	if (block->letters & AXIS_BITS & ~letter_bits("XYZ"))
		return refuse(interp, "is not supported with axes other than X, Y and Z");
	if (!block_has(block, 'P') || !block_has(block, 'Q') || !block_has(block, 'R') || !block_has(block, 'Z'))
		return refuse(interp,
			      "needs P (program of the outline), Q (depth of each pass), R (start height) and Z "
			      "(depth)");
	if (block_has(block, 'I') == block_has(block, 'J'))
		return refuse(interp, "needs either I or J (width of cut)");
	if (!(block_value(block, 'Q') > 0) || !(block_value(block, block_has(block, 'I') ? 'I' : 'J') > 0))
		return refuse(interp, "needs Q and I or J greater than 0");
	if (block_has(block, 'L'))
		return fault(&interp->at, block_column(block, 'L'), "L of G150 is not supported; repeat the block");
	return block_value(block, 'R') > block_value(block, 'Z') || refuse(interp, "needs R above Z");
}

/* With a negative radius the tool leaves the outline. */
static bool find_radius(struct interp *interp, double *beyond)
{
	const struct radius_offset *tool =
	    interp->comp.number > 0 ? tool_table_radius(&interp->tools, interp->comp.number) : NULL;

	if (interp->comp.number > 0 && interp->config->has_setup && !tool)
		return fault(&interp->at, interp->block.g_column[G_NONMODAL],
			     "the setup has no radius %d: add <offset number=\"%d\" radius=\"\"/>", interp->comp.number,
			     interp->comp.number);
	*beyond = tool ? fmax(-tool->radius, 0) : 0;
	return true;
}

bool pocket_milling_begin(struct interp *interp)
{
	struct state *state = &interp->state;
	struct pocket_milling *pocket = &state->pocket_milling;
	const struct block *block = &interp->block;
	const double zero = state->offset.v[SLOT_Z];
	double beyond = 0;

	if (!check_state(interp) || !check_words(interp) || !find_radius(interp, &beyond))
		return false;
	if (!(state->feed_linear > 0) || state->feed_mode != FEED_PER_MINUTE)
		return refuse(interp, "needs a feed rate (F) in G94");
	if (!motion_commands_feed(interp, &pocket->feed))
		return false;
	pocket->here = state->position;
	pocket->beyond = beyond;
	pocket->top = zero + block_value(block, 'R') * state->scale;
	pocket->bottom = zero + block_value(block, 'Z') * state->scale;
	pocket->points = 0;
	pocket->area = 0;
	for (int slot = SLOT_X; slot <= SLOT_Y; slot++) {
		if (block_has(block, AXIS_LETTERS[slot]))
			state_set_position(state, slot,
					   state->offset.v[slot] +
						   block_value(block, AXIS_LETTERS[slot]) * state->scale);
		pocket->hole[slot] = pocket->low[slot] = pocket->high[slot] = state->position.v[slot];
	}
	pocket->takes = true;
	return true;
}

static bool check_outline(struct interp *interp)
{
	const struct pocket_milling *pocket = &interp->state.pocket_milling;

	if (!pocket_outline_is_closed(pocket))
		return fault(&interp->at, 1,
			     "the outline of the G150 pocket is not closed: it must return to the end point of its "
			     "first move");
	return pocket->side * pocket->area >= 0 ||
	       fault(&interp->at, 1,
		     "G%d leads the tool along the outside of this G150 outline: reverse the outline",
		     pocket->side > 0 ? 41 : 42);
}

/* ---------------------------------------------------------- what it may do */

static bool go(struct interp *interp, const double point[3], const struct parallel_box *box, double feed)
{
	const struct canon_move move = {.kind = feed > 0 ? CANON_FEED : CANON_RAPID, .feed.linear = feed};
	slot_values target = interp->state.position;

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		target.v[slot] = point[slot];
	return parallel_moves_go(interp, &target, &move, box);
}

/* To the hole and to R: the manual does not give the order, so the tool may be anywhere in the box of both moves. */
static bool approach(struct interp *interp)
{
	const struct pocket_milling *pocket = &interp->state.pocket_milling;
	const double *here = pocket->here.v, *hole = pocket->hole;
	const double spread[3] = {fabs(hole[0] - here[0]) / 2, fabs(hole[1] - here[1]) / 2, 0}, none[3] = {0};
	const struct parallel_box narrow = parallel_moves_box(none), box = parallel_moves_box(spread);
	const double middle[3] = {(here[0] + hole[0]) / 2, (here[1] + hole[1]) / 2, here[SLOT_Z]};
	const double over[3] = {middle[0], middle[1], pocket->top}, start[3] = {hole[0], hole[1], pocket->top};

	return go(interp, middle, &narrow, 0) && go(interp, over, &box, 0) && go(interp, start, &narrow, 0);
}

/* The manual does not say whether the tool retracts to R or to its start between and after the passes. */
static bool mill(struct interp *interp)
{
	struct pocket_milling *pocket = &interp->state.pocket_milling;
	const double feed = pocket->feed.linear, upper = fmax(pocket->top, pocket->here.v[SLOT_Z]);
	const double half[3] = {(pocket->high[0] - pocket->low[0]) / 2 + pocket->beyond,
				(pocket->high[1] - pocket->low[1]) / 2 + pocket->beyond, 0};
	const struct parallel_box box = parallel_moves_box(half);
	double at[3] = {(pocket->low[0] + pocket->high[0]) / 2, (pocket->low[1] + pocket->high[1]) / 2, pocket->top};
	const double none[3] = {0};
	const struct parallel_box narrow = parallel_moves_box(none);

	if (!go(interp, at, &narrow, feed))
		return false;
	at[SLOT_Z] = pocket->bottom;
	if (!go(interp, at, &box, feed))
		return false;
	at[SLOT_Z] = upper;
	if (!go(interp, at, &box, feed))
		return false;
	at[SLOT_Z] = (upper + pocket->bottom) / 2;
	if (!go(interp, at, &box, feed))
		return false;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		interp->comp.loose[slot] = slot == SLOT_Z ? (upper - pocket->bottom) / 2 : half[slot];
		pocket->open[slot] = true;
	}
	return true;
}

bool pocket_milling_finish(struct interp *interp)
{
	struct pocket_milling *pocket = &interp->state.pocket_milling;

	if (!pocket->takes)
		return true;
	pocket->takes = false;
	if (!check_outline(interp))
		return false;
	for (int slot = SLOT_X; slot <= SLOT_Y; slot++)
		state_set_position(&interp->state, slot, pocket->here.v[slot]);
	return approach(interp) && mill(interp);
}
