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

/* "the setup defines no tool T5", unless it does, or there is no setup. */
static bool check_tool(struct interp *interp, int number, int column)
{
	if (!interp->config->has_setup || number == 0 || tool_table_find(&interp->tools, number))
		return true;
	return fault(&interp->at, column,
		     "the setup defines no tool T%d: add <tool number=\"%d\" length=\"\"/> with what it is made of",
		     number, number);
}

/* LinuxCNC's manual, "M61": another tool is in the spindle, and nothing has moved. */
static bool set_tool(struct interp *interp)
{
	struct state *state = &interp->state;
	int column = interp->block.m_column[M_TOOL], number;

	if (!block_has(&interp->block, 'Q'))
		return fault(&interp->at, column, "M61 needs Q, the number of the tool in the spindle");
	if (!block_integer(&interp->block, &interp->at, 'Q', 0, INT_MAX, &number) ||
	    !check_tool(interp, number, block_column(&interp->block, 'Q')))
		return false;
	state->tool = number;
	state->tool_by_m61 = true;
	return motion_commands_emit(interp, &(struct canon_move){.kind = CANON_TOOL_CHANGE, .tool = number}) &&
	       motion_commands_cover_probed(interp, column);
}

bool tool_change_run(struct interp *interp)
{
	const struct block *block = &interp->block;
	struct state *state = &interp->state;
	int column = block_has(block, 'T') ? block_column(block, 'T') : block->m_column[M_TOOL];

	if (block->m[M_TOOL] == CODE_NONE)
		return true;
	if (block->m[M_TOOL] == 61)
		return set_tool(interp);
	if (state->selected < 0)
		return fault(&interp->at, column, "M6, but no T has selected a tool");
	if (!check_tool(interp, state->selected, column))
		return false;
	if (!motion_commands_spindle_stops(interp) || !reference_return_change_tool(interp))
		return false;
	state->tool = state->selected;
	state->tool_by_m61 = false;
	state->spindle = SPINDLE_STOPPED;
	return motion_commands_emit(interp, &(struct canon_move){.kind = CANON_TOOL_CHANGE, .tool = state->tool}) &&
	       motion_commands_cover_probed(interp, column);
}
