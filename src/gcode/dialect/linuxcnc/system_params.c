#include "gcode/dialect/linuxcnc/system_params.h"

#include <math.h>

#include "gcode/dialect/linuxcnc/linuxcnc_state.h"
#include "gcode/execute/program_position.h"
#include "gcode/execute/work_offset_use.h"

/* Ranges of numbers, each with one value for each slot. */
enum {
	MACHINE_POSITION = 5021,
	PROBE = 5061,
	PROBE_RESULT = 5070,
	LENGTH_OFFSET = 5081,
	REFERENCE_1 = 5161,
	REFERENCE_2 = 5181,
	SHIFT_APPLIED = 5210,
	SHIFT = 5211,
	SYSTEM = 5220,
	WORK = 5221,
	WORK_STEP = 20,
	WORK_END = WORK + SYSTEM_COUNT * WORK_STEP,
	INPUT = 5399,
	TOOL = 5400,
	TOOL_OFFSET = 5401,
	TOOL_DIAMETER = 5410,
	TOOL_END = 5413,
	POSITION = 5420,
	CHANGER_FAULT = 5600,
	CHANGER_REASON = 5601
};

static bool in_slots(int number, int first)
{
	return number >= first && number < first + SLOT_COUNT;
}

/* The name of data that only the machine knows; NULL: the parameter is none of these. */
static const char *real_time(int number)
{
	if (number >= PROBE && number <= PROBE_RESULT)
		return "a probed position";
	if (number == INPUT)
		return "an input that M66 has read";
	if (number == CHANGER_FAULT || number == CHANGER_REASON)
		return "a report of the tool changer";
	return NULL;
}

/* The control's own unit of length in mm (LinuxCNC's manual, "[TRAJ] LINEAR_UNITS"); angles are degrees. */
static double unit_of(const struct interp *interp, int slot)
{
	return slot_is_rotary(slot) || !(interp->config->controller.unit > 0) ? 1 : interp->config->controller.unit;
}

static bool differs_by_version(int number)
{
	return in_slots(number, MACHINE_POSITION) || in_slots(number, LENGTH_OFFSET);
}

/* -------------------------------------------------------------- the tool */

static bool tool_number(struct interp *interp, int number, int column, double *value)
{
	const struct tool *tool = tool_table_find(&interp->tools, interp->state.tool);

	*value = number == TOOL ? interp->state.tool : 0;
	if (number == TOOL || interp->state.tool == 0)
		return true;
	if (!tool)
		return fault(&interp->at, column, "#%d: the setup does not define the tool in the spindle, T%d", number,
			     interp->state.tool);
	if (number > TOOL_DIAMETER)
		return fault(&interp->at, column,
			     "#%d: angles and orientation of lathe tools are not supported",
			     number);
	if (number == TOOL_DIAMETER)
		*value = tool->diameter / unit_of(interp, SLOT_X);
	else if (number == TOOL_OFFSET + SLOT_Z)
		*value = tool->length_offset / unit_of(interp, SLOT_Z);
	return true;
}

/* ------------------------------------------------------ offsets, position */

static double own_length(const struct interp *interp, const slot_values *values, int slot)
{
	return values->v[slot] / unit_of(interp, slot);
}

static double work_number(struct interp *interp, int number, int column)
{
	int system = (number - WORK) / WORK_STEP, slot = (number - WORK) % WORK_STEP;

	if (slot >= SLOT_COUNT)
		return slot == SLOT_COUNT ? 0 : linuxcnc_of(interp)->params.numbered[number];
	work_offset_use_note(interp, system, column);
	return own_length(interp, &interp->state.work[system], slot);
}

bool system_params_number(struct interp *interp, int number, int column, double *value)
{
	const struct state *state = &interp->state;
	const char *who = real_time(number);

	*value = linuxcnc_of(interp)->params.numbered[number];
	if (number < MACHINE_POSITION)
		return true;
	if (who)
		return fault(&interp->at, column, "#%d (%s) is not known before the program runs", number,
			     who);
	if (differs_by_version(number))
		return fault(&interp->at, column, "the value of #%d depends on the version of LinuxCNC", number);
	if (number >= TOOL && number <= TOOL_END)
		return tool_number(interp, number, column, value);
	if (in_slots(number, POSITION)) {
		*value = program_position_value(state, number - POSITION);
		return program_position_check(interp, number - POSITION, column);
	}
	if (in_slots(number, REFERENCE_1))
		*value = own_length(interp, &state->reference[0], number - REFERENCE_1);
	else if (in_slots(number, REFERENCE_2))
		*value = own_length(interp, &state->reference[1], number - REFERENCE_2);
	else if (number == SHIFT_APPLIED)
		*value = state->shift_applied;
	else if (in_slots(number, SHIFT))
		*value = own_length(interp, &state->saved_shift, number - SHIFT);
	else if (number == SYSTEM)
		*value = state->system + 1;
	else if (number >= WORK && number < WORK_END)
		*value = work_number(interp, number, column);
	return true;
}

/* LinuxCNC applies a new value of these at some later time, or never: the program is refused. */
static bool check_work(struct interp *interp, int number, int column)
{
	int system = (number - WORK) / WORK_STEP, slot = (number - WORK) % WORK_STEP;

	if (slot == SLOT_COUNT)
		return fault(&interp->at, column, "#%d: rotation of a coordinate system is not supported", number);
	if (slot > SLOT_COUNT || system != interp->state.system)
		return true;
	return fault(&interp->at, column,
		     "#%d belongs to %s, which is active: LinuxCNC uses the new value only when %s is selected again; "
		     "use G10 L2 P%d",
		     number, state_system_name(system), state_system_name(system), system + 1);
}

bool system_params_check_number(struct interp *interp, int number, int column)
{
	if ((number >= TOOL && number <= TOOL_END) || in_slots(number, POSITION))
		return fault(&interp->at, column, "#%d is read-only", number);
	if (differs_by_version(number))
		return fault(&interp->at, column, "the value of #%d depends on the version of LinuxCNC", number);
	if (number == SYSTEM)
		return fault(&interp->at, column, "#%d does not select a coordinate system; use G54 to G59.3", number);
	if (number == SHIFT_APPLIED)
		return fault(&interp->at, column, "#%d does not apply the shift; use G92.2 and G92.3", number);
	if (number >= WORK && number < WORK_END)
		return check_work(interp, number, column);
	return true;
}

static void take_length(const struct interp *interp, slot_values *values, int slot, double value)
{
	values->v[slot] = value * unit_of(interp, slot);
}

static void set_number(struct interp *interp, int number, double value)
{
	struct state *state = &interp->state;
	int system = (number - WORK) / WORK_STEP, slot = (number - WORK) % WORK_STEP;

	linuxcnc_of(interp)->params.numbered[number] = value;
	if (in_slots(number, REFERENCE_1)) {
		take_length(interp, &state->reference[0], number - REFERENCE_1, value);
	} else if (in_slots(number, REFERENCE_2)) {
		take_length(interp, &state->reference[1], number - REFERENCE_2, value);
	} else if (in_slots(number, SHIFT)) {
		take_length(interp, &state->saved_shift, number - SHIFT, value);
	} else if (number >= WORK && number < WORK_END && slot < SLOT_COUNT) {
		take_length(interp, &state->work[system], slot, value);
		state->work_known[system] = true;
	}
}

/* Assignments take effect before the block's codes, but after all of its words were read. */
bool system_params_assign(struct interp *interp)
{
	struct params *params = &linuxcnc_of(interp)->params;

	for (size_t i = 0; i < params->pending_count; i++) {
		const struct assignment *new = &params->pending[i];

		if (new->number > 0)
			set_number(interp, new->number, new->value);
		else
			params_make(params, new->name)->value = new->value;
	}
	params->pending_count = 0;
	return true;
}
