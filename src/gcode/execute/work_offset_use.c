#include "gcode/execute/work_offset_use.h"

#include "base/same_double.h"

void work_offset_use_note(struct interp *interp, int system, int column)
{
	if (interp->config->has_setup && !interp->state.work_known[system])
		caution(&interp->at, column, "the setup defines no work offset %s; it is taken as 0",
			state_system_name(system));
	interp->state.work_known[system] = true;
}

bool work_offset_use_require(struct interp *interp, int system, int column)
{
	const char *name = state_system_name(system);

	if (!interp->config->has_setup || interp->state.work_known[system])
		return true;
	return fault(
	    &interp->at, column,
	    "the setup defines no work offset %s: add <work_offset name=\"%s\" X=\"\" Y=\"\" Z=\"\"/> with its values",
	    name, name);
}

bool work_offset_use_fault(const struct interp *interp, int column)
{
	const char *name = state_system_name(interp->state.system);

	return fault(&interp->at, column,
		     "%s was changed by assignment while it was in force; controls differ in when that takes effect. "
		     "Select %s again before the next move",
		     name, name);
}

bool work_offset_use_check(struct interp *interp)
{
	const struct block *block = &interp->block;
	struct state *state = &interp->state;

	if (!state->work_assigned)
		return true;
	if (block->g[G_SYSTEM] != CODE_NONE)
		state->work_assigned = false;
	else if (block->letters & AXIS_BITS)
		return work_offset_use_fault(interp, block_motion_column(block));
	return true;
}

bool work_offset_use_check_end(struct interp *interp)
{
	const struct block *block = &interp->block;
	const bool by_table = block->g[G_NONMODAL] == G54_2;

	return (block_has(block, 'P') && same_double(block_value(block, 'P'), 0)) ||
	       fault(&interp->at, block->g_column[G_NONMODAL], "%s is not supported yet, and P0, which ends it, is "
							       "read",
		     by_table ? "G54.2: rotary table dynamic fixture offset (post with a work offset for each angle)"
			      : "G54.4: work setting error compensation");
}
