#include "gcode/dialect/sinumerik/block/sinumerik_tool.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "base/mem.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_seek.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/execute/tool_change.h"
#include "gcode/execute/tool_length.h"

/* The maximum number of tool names without a setup. */
#define NAMES_MAX 10000

/* Without a setup, each name gets a number of its own, in the order of the program. */
static bool number_name(struct interp *interp, const char *name, int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	size_t i = 0;

	while (i < sinumerik->tool.name_count && !ascii_same(sinumerik->tool.names[i].bytes, name))
		i++;
	if (i >= NAMES_MAX)
		return fault(&interp->at, column, "the program names more than %d tools", NAMES_MAX);
	if (i == sinumerik->tool.name_count) {
		sinumerik->tool.names = mem_grow(sinumerik->tool.names, &sinumerik->tool.name_capacity, i + 1,
						 sizeof(*sinumerik->tool.names));
		strcpy(sinumerik->tool.names[sinumerik->tool.name_count++].bytes, name);
	}
	interp->state.selected = (int)i + 1;
	return true;
}

static bool select_by_name(struct interp *interp, const char *name, int column)
{
	const struct tool *tool;

	/* If the name is not found, M6 does not report it again. */
	interp->state.selected = 0;
	if (name[0] == '\0' || !strcmp(name, "0"))
		return true;
	if (!interp->config->has_setup)
		return number_name(interp, name, column);
	if (!tool_table_find_name(&interp->tools, &interp->at, column, name, true, &tool))
		return false;
	interp->state.selected = tool->number;
	return true;
}

static bool select_tool(struct interp *interp, const struct sinumerik_block *block)
{
	const int index = 'T' - 'A', column = block->column[index];
	const double value = block->value[index];

	if (!sinumerik_block_has(block, 'T'))
		return true;
	if (block->names_tool)
		return select_by_name(interp, block->tool_name.bytes, column);
	if (!(value >= 0 && value <= INT_MAX) || floor(value) < value)
		return fault(&interp->at, column, "T must be a whole number that is not negative, not %.15g", value);
	interp->state.selected = (int)value;
	return true;
}

/* ------------------------------------------------------------------- edges */

static bool find_length(struct interp *interp, int edge, int column, double *length)
{
	const int number = interp->state.tool;
	const struct tool *tool = tool_table_find(&interp->tools, number);

	*length = 0;
	if (edge == 0 || number == 0)
		return true;
	if (!tool && !interp->config->has_setup)
		return fault(&interp->at, column,
			     "D%d of the tool in the spindle: its length is not known without a setup", edge);
	/* It was reported that the setup lacks the tool; every tool of a setup has an edge D1. */
	if (!tool && edge == 1 && interp->faulty)
		return true;
	if (tool && (edge == 1 || tool == interp->config->any_tool)) {
		*length = tool->length_offset;
		return true;
	}
	for (size_t i = 0; tool && i < interp->config->edge_count; i++) {
		const struct tool_edge *found = &interp->config->edges[i];

		if (found->tool == number && found->number == edge) {
			*length = found->length + interp->config->length_change;
			return true;
		}
	}
	return fault(&interp->at, column,
		     "the setup defines no edge D%d of tool T%d: add <edge number=\"%d\" length=\"\"/> to it", edge,
		     number, edge);
}

static bool set_edge(struct interp *interp, int edge, int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	struct state *state = &interp->state;
	double length;

	if (!find_length(interp, edge, column, &length))
		return false;
	sinumerik_frame_place(interp);
	sinumerik->tool.edge = edge;
	sinumerik->tool.edge_unsure = false;
	state->length = length;
	state_update_offset(state);
	if (state->tcp != TCP_OFF && !tool_length_switch_tcp(interp, column, state->tcp))
		return false;
	return sinumerik_frame_changed(interp, column);
}

static bool set_programmed_edge(struct interp *interp, const struct sinumerik_block *block)
{
	const int index = 'D' - 'A';
	const double value = block->value[index];

	if (!sinumerik_block_has(block, 'D'))
		return true;
	if (!(value >= 0 && value <= 32000) || floor(value) < value)
		return fault(&interp->at, block->column[index], "D must be a whole number from 0 to 32000, not %.15g",
			     value);
	return set_edge(interp, (int)value, block->column[index]);
}

/* MD20270: the edge that M6 makes active. */
static bool edge_of_change(struct interp *interp, const struct sinumerik_block *block, int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);

	if (sinumerik_block_has(block, 'D'))
		return true;
	switch (interp->config->controller.edge_after_tool_change) {
	case EDGE_AFTER_TOOL_CHANGE_FIRST:
		return set_edge(interp, interp->state.tool == 0 ? 0 : 1, column);
	case EDGE_AFTER_TOOL_CHANGE_NONE:
		return set_edge(interp, 0, column);
	case EDGE_AFTER_TOOL_CHANGE_KEEPS:
		return set_edge(interp, sinumerik->tool.edge, column);
	default:
		break;
	}
	if (interp->state.tool == 0)
		return set_edge(interp, 0, column);
	sinumerik->tool.edge_unsure = true;
	return true;
}

static bool change_tool(struct interp *interp, const struct sinumerik_block *block, int column)
{
	bool good;

	if (sinumerik_of(interp)->frames.swivelled)
		sinumerik_frame_place(interp);
	interp->block.m[M_TOOL] = 6;
	interp->block.m_column[M_TOOL] = column;
	interp->block.letters = 0;
	good = tool_change_run(interp);
	interp->block.m[M_TOOL] = CODE_NONE;
	if (!good)
		return false;
	sinumerik_frame_moved(interp);
	return edge_of_change(interp, block, column);
}

/* If the program has an M6 anywhere, T waits for it. Each file is searched once. */
static bool look_for_change(struct interp *interp, const struct sinumerik_block *block)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);

	if (!sinumerik_block_has(block, 'T') || sinumerik->tool.changed || sinumerik->tool.changes_ahead ||
	    interp->config->controller.t_changes_tool != ANSWER_UNKNOWN ||
	    sinumerik->tool.no_change_ahead == interp->program.source)
		return true;
	if (!sinumerik_seek_tool_change(interp, block->column['T' - 'A'], &sinumerik->tool.changes_ahead))
		return false;
	if (!sinumerik->tool.changes_ahead)
		sinumerik->tool.no_change_ahead = interp->program.source;
	return true;
}

/* MD22550: either T changes the tool, or M6 does. */
bool sinumerik_tool_run(struct interp *interp, const struct sinumerik_block *block)
{
	const bool by_t = interp->config->controller.t_changes_tool == ANSWER_YES;
	struct sinumerik *sinumerik = sinumerik_of(interp);

	if (!select_tool(interp, block))
		return false;
	if (by_t && sinumerik_block_has(block, 'T') && !change_tool(interp, block, block->column['T' - 'A']))
		return false;
	sinumerik->tool.t_waits = sinumerik->tool.t_waits || sinumerik_block_has(block, 'T');
	for (int i = 0; i < block->m_count && !by_t; i++) {
		if (block->m[i] != 6)
			continue;
		if (!change_tool(interp, block, block->m_column[i]))
			return false;
		sinumerik->tool.changed = true;
	}
	return look_for_change(interp, block) && set_programmed_edge(interp, block);
}

double sinumerik_tool_radius(const struct interp *interp)
{
	const struct tool *tool = tool_table_find(&interp->tools, interp->state.tool);
	const int edge = sinumerik_of(interp)->tool.edge;
	double diameter = tool ? tool->diameter : 0;

	for (size_t i = 0; tool && i < interp->config->edge_count; i++) {
		const struct tool_edge *found = &interp->config->edges[i];

		if (found->tool == tool->number && found->number == edge && fabs(found->diameter) > 0)
			diameter = fmax(0, found->diameter);
	}
	return edge == 0 ? 0 : diameter / 2;
}
