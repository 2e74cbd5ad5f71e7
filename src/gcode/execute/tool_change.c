#include "gcode/execute/tool_change.h"

#include <limits.h>
#include <math.h>

#include "base/same_double.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/reference_return.h"
#include "gcode/execute/tool_table.h"
#include "gcode/read_on.h"

/*
 * M6 and T in one block: if the machine builder's M6 and T act at the same time, M6 may load the tool of an earlier T,
 * and the T of the block is for the next M6. This makes a difference only if an earlier T waits.
 */
static bool choose_own(struct interp *interp, int before)
{
	struct state *state = &interp->state;
	const int own = state->selected, column = block_column(&interp->block, 'T');
	const enum m6_with_t answer = interp->config->controller.m6_with_t;

	if (interp->block.m[M_TOOL] != 6 || traits_of(interp)->m6_loads_own_t == ANSWER_YES)
		return true;
	if (!is_answered(interp, column, traits_of(interp)->m6_loads_own_t, "which tool M6 loads if T is in its block"))
		return false;
	if (answer == M6_LOADS_T_BEFORE) {
		state->selected = before;
		state->selected_next = own;
		return true;
	}
	if (answer == M6_LOADS_OWN_T || answer == M6_LOADS_FIRST_T || before < 0 || before == state->tool ||
	    before == own)
		return true;
	if (!interp->cautioned_t)
		caution(
		    &interp->at, column,
		    "T%d beside M6 while T%d is preselected: it is assumed that M6 loads T%d, but the builder may have "
		    "it load T%d; set m6_with_t=\"own\" or \"before\" in the machine file's <controller>; here and "
		    "further on",
		    own, before, own, before);
	interp->cautioned_t = true;
	return true;
}

/* "T1 T2 M6" of Mazak's EIA programs: M6 loads the first tool, and the second is for the next M6. */
static bool choose_next(struct interp *interp)
{
	const struct block *block = &interp->block;

	if (!block->has_next_tool)
		return true;
	if (block->m[M_TOOL] != 6)
		return fault(&interp->at, block->next_tool_column, "two T in a block without M6");
	if (!(block->next_tool >= 0 && block->next_tool <= INT_MAX) ||
	    !same_double(floor(block->next_tool), block->next_tool))
		return fault(&interp->at, block->next_tool_column, "T%.10g: a tool number must be whole",
			     block->next_tool);
	interp->state.selected_next = (int)block->next_tool;
	return true;
}

bool tool_change_select(struct interp *interp)
{
	const int before = interp->state.selected;
	double number;

	if (!block_has(&interp->block, 'T'))
		return true;
	number = block_value(&interp->block, 'T');
	/* block_integer judges a nearly whole number. */
	if (fabs(number - round(number)) > 0.01)
		return fault(&interp->at, block_column(&interp->block, 'T'),
			     "T%.10g: a tool number must be whole; where T1.1 is a tool and its offset (Fagor), write "
			     "T1, and H1 or D1 for the offset",
			     number);
	return is_answered(interp, block_column(&interp->block, 'T'), traits_of(interp)->t_word,
			   "whether T changes the tool or selects it for M6") &&
	       block_integer(&interp->block, &interp->at, 'T', 0, INT_MAX, &interp->state.selected) &&
	       choose_own(interp, before) && choose_next(interp);
}

/* Reports that the setup does not define the tool, if there is a setup. */
static bool check_tool(struct interp *interp, int number, int column)
{
	if (!interp->config->has_setup || number == 0 || tool_table_find(&interp->tools, number))
		return true;
	return read_on_without(
	    interp, column,
	    "the setup defines no tool T%d: add <tool number=\"%d\" length=\"\"/> with its shape", number,
	    number);
}

/* LinuxCNC's manual, "M61": another tool is in the spindle, without a move. */
static bool set_tool(struct interp *interp)
{
	struct state *state = &interp->state;
	int column = interp->block.m_column[M_TOOL], number;

	if (!block_has(&interp->block, 'Q'))
		return fault(&interp->at, column, "M61 needs Q (number of the tool in the spindle)");
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
		return fault(&interp->at, column, "M6 without a tool: write T first");
	if (!check_tool(interp, state->selected, column))
		return false;
	if (!motion_commands_spindle_stops(interp) || !reference_return_change_tool(interp))
		return false;
	state->tool = state->selected;
	if (state->selected_next >= 0)
		state->selected = state->selected_next;
	state->selected_next = -1;
	state->tool_by_m61 = false;
	state->spindle = SPINDLE_STOPPED;
	return motion_commands_emit(interp, &(struct canon_move){.kind = CANON_TOOL_CHANGE, .tool = state->tool}) &&
	       motion_commands_cover_probed(interp, column);
}
