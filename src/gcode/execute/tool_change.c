#include "gcode/execute/tool_change.h"

#include <limits.h>

#include "gcode/execute/motion_commands.h"
#include "gcode/execute/reference_return.h"
#include "gcode/execute/tool_table.h"

bool tool_change_select(struct interp *interp)
{
	if (!block_has(&interp->block, 'T'))
		return true;
	return is_answered(interp, block_column(&interp->block, 'T'), traits_of(interp)->t_word,
			   "whether T changes the tool or selects it for M6") &&
	       block_integer(&interp->block, &interp->at, 'T', 0, INT_MAX, &interp->state.selected);
}

bool tool_change_run(struct interp *interp)
{
	const struct block *block = &interp->block;
	struct state *state = &interp->state;
	int column = block_has(block, 'T') ? block_column(block, 'T') : block->m_column[M_TOOL];

	if (block->m[M_TOOL] == CODE_NONE)
		return true;
	if (state->selected < 0)
		return fault(&interp->at, column, "M6, but no T has selected a tool");
	if (interp->config->has_setup && state->selected != 0 && !tool_table_find(&interp->tools, state->selected))
		return fault(&interp->at, column, "the setup defines no tool T%d: add <tool number=\"%d\" length=\"\"/> with what it is made of",
			     state->selected, state->selected);
	if (!motion_commands_spindle_stops(interp) || !reference_return_change_tool(interp))
		return false;
	state->tool = state->selected;
	state->spindle = SPINDLE_STOPPED;
	return motion_commands_emit(interp, &(struct canon_move){.kind = CANON_TOOL_CHANGE, .tool = state->tool}) &&
	       motion_commands_cover_probed(interp, column);
}
