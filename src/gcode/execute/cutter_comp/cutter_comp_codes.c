#include "gcode/execute/cutter_comp/cutter_comp.h"

#include <math.h>

static bool find_radius(struct interp *interp, double *radius)
{
	const struct block *block = &interp->block;
	const struct tool *tool;
	int code = block->g[G_CUTTER], column = block->g_column[G_CUTTER], number = interp->state.tool;

	if (code == G41_1 || code == G42_1) {
		if (!block_has(block, 'D'))
			return fault(&interp->at, column, "G%d.1 needs the tool's diameter in D", code / 10);
		*radius = block_value(block, 'D') * interp->state.scale / 2;
		return true;
	}
	if (block_has(block, 'D')) {
		column = block_column(block, 'D');
		if (!block_integer(block, &interp->at, 'D', 0, 1000000, &number))
			return false;
		number = number == 0 ? interp->state.tool : number;
	}
	tool = tool_table_find(&interp->tools, number);
	*radius = tool ? tool->diameter / 2 : 0;
	return tool || number == 0 ||
	       fault(&interp->at, column, "the diameter of tool T%d is not known; a setup defines it", number);
}

bool cutter_comp_switch_on(struct interp *interp)
{
	const struct block *block = &interp->block;
	struct cutter_comp *comp = &interp->comp;
	int code = block->g[G_CUTTER], column = block->g_column[G_CUTTER];
	double radius = 0;

	if (interp->state.plane == G19)
		return fault(&interp->at, column, "cutter compensation works in the planes of G17 and G18 only");
	if (comp->side != 0)
		return fault(&interp->at, column, "cutter compensation is on already; G40 first");
	if (block_has(block, 'L'))
		return fault(&interp->at, block_column(block, 'L'),
			     "L: the orientation of a lathe tool is not supported yet");
	if (!find_radius(interp, &radius))
		return false;
	comp->side = code == G41 || code == G41_1 ? 1 : -1;
	/* A negative diameter exchanges the sides. */
	if (radius < 0)
		comp->side = -comp->side;
	comp->radius = fabs(radius);
	comp->entered = false;
	return true;
}

static bool refuse(struct interp *interp, int column, const char *what)
{
	return fault(&interp->at, column, "%s while cutter compensation is on; G40 first", what);
}

bool cutter_comp_start_block(struct interp *interp)
{
	const struct block *block = &interp->block;

	if (interp->comp.side == 0)
		return true;
	if (block->m[M_TOOL] != CODE_NONE)
		return refuse(interp, block->m_column[M_TOOL], "a tool change");
	if (block->m[M_TCP] != CODE_NONE)
		return refuse(interp, block->m_column[M_TCP], "tool centre point control");
	if (block->g[G_PLANE] != CODE_NONE && block->g[G_PLANE] != interp->state.plane)
		return refuse(interp, block->g_column[G_PLANE], "a change of the plane");
	return true;
}

static bool moves_as_compensated(int motion)
{
	return motion == CODE_NONE || motion == G80 || motion == G0 || motion == G1 || motion == G2 || motion == G3;
}

bool cutter_comp_check_block(struct interp *interp)
{
	static const struct {
		enum g_group group;
		const char *what;
	} groups[] = {{G_LENGTH, "a change of the tool length"},
		      {G_SYSTEM, "a change of the work offset"},
		      {G_PATH, "a change of the path mode"},
		      {G_RETRACT, "a change of the retract mode"}};
	const struct block *block = &interp->block;
	int code = block->g[G_NONMODAL];

	if (interp->comp.side == 0)
		return true;
	for (size_t i = 0; i < sizeof(groups) / sizeof(groups[0]); i++)
		if (block->g[groups[i].group] != CODE_NONE)
			return refuse(interp, block->g_column[groups[i].group], groups[i].what);
	if (code != CODE_NONE && code != G4 && !(code == G53 && !cutter_comp_is_on(interp)))
		return refuse(interp, block->g_column[G_NONMODAL], "a code that moves or shifts the machine's axes");
	if (!moves_as_compensated(block->motion))
		return refuse(interp, block_motion_column(block), "a canned cycle, thread or probe");
	if (cutter_comp_is_on(interp) && interp->state.feed_mode == FEED_INVERSE_TIME && block->motion >= G1)
		return fault(&interp->at, block_motion_column(block),
			     "inverse time mode (G93) under cutter compensation is not supported yet");
	return true;
}
