#include "gcode/execute/circular_pocket.h"

#include <math.h>

#include "base/units.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"
#include "gcode/execute/endpoint.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/tool_table.h"

/* The number of circles that cover the pocket: more circles have smaller spreads. */
#define RINGS 8

#define REPEATS_MAX 1000

struct pocket {
	slot_values centre;	/* at the final depth */
	double radius;	/* mm: of the tool's axis about the centre */
	double top;	/* straight position of Z before the cycle */
	struct canon_feed feed;
};

static bool refuse(struct interp *interp, const char *why)
{
	return fault(&interp->at, interp->block.g_column[G_NONMODAL], "G%d %s", interp->block.g[G_NONMODAL] / 10, why);
}

static bool check_state(struct interp *interp)
{
	const struct state *state = &interp->state;

	if (state->plane != G17)
		return refuse(interp, "needs the plane of G17");
	if (state->frame.on || state->tcp != TCP_OFF || state->polar.on || cutter_comp_is_on(interp))
		return refuse(interp,
			      "is not supported in changed coordinates, under tool centre point control or under "
			      "cutter compensation");
	for (const char *letter = "ABCUVW"; *letter; letter++) {
		if (block_has(&interp->block, *letter))
			return fault(&interp->at, block_column(&interp->block, *letter), "%c with G%d is not supported",
				     *letter, interp->block.g[G_NONMODAL] / 10);
	}
	return true;
}

/* With D0, or without any D, the radii are those of the path of the tool's axis. */
static bool find_radius(struct interp *interp, struct pocket *pocket)
{
	const struct block *block = &interp->block;
	char letter = block_has(block, 'K') ? 'K' : 'I';
	const struct radius_offset *tool;

	if (!block_has(block, letter))
		return refuse(interp, "needs I or K (radius of the pocket)");
	pocket->radius = block_value(block, letter) * interp->state.scale;
	tool = interp->comp.number > 0 ? tool_table_radius(&interp->tools, interp->comp.number) : NULL;
	if (interp->comp.number > 0 && interp->config->has_setup && !tool)
		return fault(&interp->at, interp->block.g_column[G_NONMODAL],
			     "the setup has no radius %d: add <offset number=\"%d\" radius=\"\"/>", interp->comp.number,
			     interp->comp.number);
	pocket->radius -= tool ? fabs(tool->radius) : 0;
	return pocket->radius > 0 ||
	       fault(&interp->at, block_column(block, letter), "the tool is too large for the pocket");
}

/* With G91 each of the L passes is deeper by Z. */
static bool find_depth(struct interp *interp, struct pocket *pocket)
{
	const struct block *block = &interp->block;
	int passes = 1;

	if (block_has(block, 'L') && !block_integer(block, &interp->at, 'L', 1, REPEATS_MAX, &passes))
		return false;
	if (passes > 1 && !interp->state.incremental)
		return fault(&interp->at, block_column(block, 'L'), "L of G%d needs G91",
			     block->g[G_NONMODAL] / 10);
	if (!endpoint_find(interp, false, &pocket->centre))
		return false;
	pocket->top = interp->state.position.v[SLOT_Z];
	pocket->centre.v[SLOT_Z] = pocket->top + (pocket->centre.v[SLOT_Z] - pocket->top) * passes;
	return true;
}

/* Moves on a circle about the centre at half depth; its spread covers the ring. */
static bool go_round(struct interp *interp, const struct pocket *pocket, double radius)
{
	slot_values start = pocket->centre;
	double half = (pocket->top - pocket->centre.v[SLOT_Z]) / 2, beside = pocket->radius / (2 * RINGS);
	struct canon_move move = {.kind = CANON_FEED, .feed = pocket->feed, .spread = {beside, beside, fabs(half)}};
	struct canon_move circle = {.kind = CANON_ARC, .feed = pocket->feed, .spread = {beside, beside, fabs(half)}};

	start.v[SLOT_X] += radius;
	start.v[SLOT_Z] += half;
	circle.arc.centre =
	    (vec3){pocket->centre.v[SLOT_X], pocket->centre.v[SLOT_Y], start.v[SLOT_Z]};
	circle.arc.normal = (vec3){0, 0, 1};
	circle.arc.sweep = interp->block.g[G_NONMODAL] == G12 ? -2 * PI : 2 * PI;
	return motion_commands_go(interp, &start, &move) && motion_commands_go(interp, &start, &circle);
}

bool circular_pocket_mill(struct interp *interp)
{
	struct pocket pocket = {.radius = 0};
	struct canon_move rapid = {.kind = CANON_RAPID}, down;
	slot_values over;

	if (!check_state(interp))
		return false;
	if (!(interp->state.feed_linear > 0))
		return refuse(interp, "needs a feed rate (F)");
	if (!motion_commands_feed(interp, &pocket.feed) || !find_radius(interp, &pocket) ||
	    !find_depth(interp, &pocket))
		return false;
	over = pocket.centre;
	over.v[SLOT_Z] = pocket.top;
	down = (struct canon_move){.kind = CANON_FEED, .feed = pocket.feed};
	if (!motion_commands_go(interp, &over, &rapid) || !motion_commands_go(interp, &pocket.centre, &down))
		return false;
	for (int i = 0; i < RINGS; i++) {
		if (!go_round(interp, &pocket, pocket.radius * (2 * i + 1) / (2 * RINGS)))
			return false;
	}
	return motion_commands_go(interp, &pocket.centre, &down);
}
