#include "gcode/execute/work_offset_use.h"

#include <stdio.h>
#include <string.h>

#include "base/same_double.h"
#include "gcode/read_on.h"

void work_offset_use_note(struct interp *interp, int system, int column)
{
	if (interp->config->has_setup && !interp->state.work_known[system])
		caution(&interp->at, column, "the setup defines no work offset %s; it is assumed to be 0",
			state_system_name(system));
	interp->state.work_known[system] = true;
}

bool work_offset_use_require(struct interp *interp, int system, int column)
{
	const char *name = state_system_name(system);

	if (!interp->config->has_setup || interp->state.work_known[system])
		return true;
	interp->state.work_known[system] = interp->config->read.all_faults;
	return read_on_without(
	    interp, column,
	    "the setup defines no work offset %s: add <work_offset name=\"%s\" X=\"\" Y=\"\" Z=\"\"/> with its values",
	    name, name);
}

bool work_offset_use_fault(const struct interp *interp, int column)
{
	const char *name = state_system_name(interp->state.system);

	return fault(&interp->at, column,
		     "%s was changed by assignment while it was active, and controls differ in when that takes effect; "
		     "select %s again before the next move",
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

/* A work offset of the setup by its name, or NULL. */
static const struct work_offset *find_named(const struct gcode_config *config, const char *name)
{
	for (size_t i = 0; i < config->work_offset_count; i++) {
		if (!strcmp(config->work_offsets[i].name, name))
			return &config->work_offsets[i];
	}
	return NULL;
}

/*
 * B-64484EN-2, "Workpiece Setting Error Compensation": the control holds how far the workpiece lies beside its place,
 * and turned, under the number P. Where all of these values are 0, the code moves nothing.
 */
static bool use_setting_error(struct interp *interp)
{
	const int column = interp->block.g_column[G_NONMODAL];
	const struct work_offset *error;
	char name[16];
	int number;

	if (!block_integer(&interp->block, &interp->at, 'P', 1, 7, &number))
		return false;
	snprintf(name, sizeof(name), "G54.4 P%d", number);
	error = find_named(interp->config, name);
	if (!error)
		return read_on_without(
		    interp, column,
		    "%s: the setup has no such work setting error; if the work offset already contains the position of "
		    "the workpiece, add <work_offset name=\"%s\"/>, whose values are 0",
		    name, name);
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!same_double(error->value.v[slot], 0))
			return fault(&interp->at, column,
				     "%s: compensation of a work setting error other than 0 is not supported; add the "
				     "error to the work offset and write 0 in <work_offset name=\"%s\"/>",
				     name, name);
	}
	return true;
}

bool work_offset_use_check_end(struct interp *interp)
{
	const struct block *block = &interp->block;

	if (block_has(block, 'P') && same_double(block_value(block, 'P'), 0))
		return true;
	if (block->g[G_NONMODAL] == G54_4 && block_has(block, 'P'))
		return use_setting_error(interp);
	return fault(&interp->at, block->g_column[G_NONMODAL],
		     "%s is not supported, only P0, which cancels it",
		     block->g[G_NONMODAL] == G54_2
			 ? "G54.2: rotary table dynamic fixture offset (post with a work offset for each angle)"
			 : "G54.4 without P");
}
