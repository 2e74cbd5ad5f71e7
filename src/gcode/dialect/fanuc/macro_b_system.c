#include "gcode/dialect/fanuc/macro_b_system.h"

#include <math.h>

#include "gcode/dialect/fanuc/macro_b_kept.h"
#include "gcode/dialect/fanuc/macro_b_state.h"
#include "gcode/execute/program_position.h"
#include "gcode/execute/work_offset_use.h"

/* Work offsets have six axes each, and their first variables are 20 numbers apart. */
enum { WORK_STEP = 20, WORK_SLOTS = 6 };

/* UI and UO of the interface. */
enum { INPUT_FIRST = 1000, INPUT_LAST = 1199 };

/*
 * Lengths, radii or diameters and their wear: which of them a number is depends on the kind of the control's memory
 * (Fanuc's A, B or C). B-63944EN: #10001 and on for tables of more than 200 lines.
 */
static const struct macro_b_range offset_table[] = {{2001, 2999, NULL}, {10001, 13999, NULL}};

/* The number of a code that has no tenths. */
static int whole_code(int code)
{
	return code / 10;
}

/* Variables that only the machine knows, or that differ between machines. Controls may have more: macro_b_rules.h. */
static const struct macro_b_range machine_only[] = {
	{3000, 3000, "write-only"},
	{3001, 3002, "a clock"},
	{3003, 3008, "switches and settings of the control"},
	{3011, 3012, "the date and the time"},
	{3901, 3902, "the number of machined parts"},
	{5021, 5060, "the position of the machine during read-ahead (#5001 has the programmed position)"},
	{5061, 5080, "a probed position"},
	{5081, 5100, "a tool offset of the control's table"},
	{5101, 5120, "the servo deviation"},
	{5201, 5220, "an external work offset of the control, which is added to all work offsets"},
};

static const struct macro_b_range *find_range(const struct macro_b_range *ranges, size_t count, int number)
{
	for (size_t i = 0; i < count; i++) {
		if (number >= ranges[i].first && number <= ranges[i].last)
			return &ranges[i];
	}
	return NULL;
}

static const char *find_machine_only(const struct macro_b_rules *rules, int number)
{
	const struct macro_b_range *range;

	range = find_range(machine_only, sizeof(machine_only) / sizeof(*machine_only), number);
	if (!range)
		range = find_range(rules->machine_only, rules->machine_only_count, number);
	return range ? range->what : NULL;
}

static bool is_tool_offset(int number)
{
	return find_range(offset_table, sizeof(offset_table) / sizeof(*offset_table), number) != NULL;
}

static double unit_of(const struct state *state, int slot)
{
	return slot_is_rotary(slot) ? 1 : state->scale;
}

/* ------------------------------------------------------------- the modes */

static bool fault_not_followed(struct interp *interp, int number, int column)
{
	return fault(&interp->at, column, "#%d is a modal code or word whose value is not known here",
		     number);
}

static bool read_group(struct interp *interp, int number, int column, double *value)
{
	const struct state *state = &interp->state;
	int system_group = macro_b_of(interp)->rules->work_group_variable;

	if (number == system_group && state->system < 6) {
		*value = 54 + state->system;
		return true;
	}
	switch (number) {
	case 4001:
		*value = whole_code(state->motion);
		return (state->motion >= G0 && state->motion <= G3 && state->motion != G2_4) ||
		       fault_not_followed(interp, number, column);
	case 4002:
		*value = whole_code(state->plane);
		return true;
	case 4003:
		*value = state->incremental ? 91 : 90;
		return true;
	case 4005:
		*value = state->feed_mode == FEED_INVERSE_TIME ? 93 : state->feed_mode == FEED_PER_MINUTE ? 94 : 95;
		return true;
	case 4006:
		*value = state->scale > 1 ? 20 : 21;
		return true;
	case 4007:
		*value = interp->comp.side == 0 ? 40 : interp->comp.side > 0 ? 41 : 42;
		return true;
	case 4008:
		*value = whole_code(state->length_code);
		return state->length_code % 10 == 0 || fault_not_followed(interp, number, column);
	case 4009:
		*value = state->motion != CODE_NONE && code_is_cycle(state->motion) ? whole_code(state->motion) : 80;
		return true;
	case 4010:
		*value = state->retract == G99 ? 99 : 98;
		return true;
	default:
		return fault_not_followed(interp, number, column);
	}
}

/* #4001 to #4021 are codes of modal groups, #4101 to #4126 words, of the blocks before this one. */
static bool read_mode(struct interp *interp, int number, int column, double *value)
{
	const struct state *state = &interp->state;

	if (number < 4100)
		return read_group(interp, number, column, value);
	*value = number == 4109   ? state->feed_linear / state->scale
		 : number == 4111 ? state->length_number
		 : number == 4119 ? state->speed
		 : number == 4120 ? state->selected
				  : -1;
	if (*value < 0 || (number == 4109 && state->feed_mode == FEED_INVERSE_TIME))
		return fault_not_followed(interp, number, column);
	return true;
}

/* ---------------------------------------------------------- axes, offsets */

/*
 * The slot of an axis number of the control. Haas counts X Y Z A B C; on Fanuc the machine builder chooses the fourth
 * axis and further ones, unless there is only one.
 */
static bool find_slot(struct interp *interp, int number, int index, int column, int *slot)
{
	int fourth = -1, others = 0;

	*slot = index;
	if (index < 3 || macro_b_of(interp)->rules->axes_in_slot_order)
		return true;
	for (int i = SLOT_Z + 1; i < SLOT_COUNT; i++) {
		fourth = interp->config->has_axis[i] && fourth < 0 ? i : fourth;
		others += interp->config->has_axis[i];
	}
	*slot = fourth;
	if (index == 3 && others == 1)
		return true;
	return fault(&interp->at, column,
		     "#%d: the machine builder decides which axis has number %d in the control",
			number,
		     index + 1);
}

/* B-63944EN: #5001 and on are the end of the block before, in workpiece coordinates without tool compensation. */
static bool read_position(struct interp *interp, int number, int column, double *value)
{
	const struct state *state = &interp->state;
	int slot;

	if (!find_slot(interp, number, number - 5001, column, &slot) ||
	    !program_position_check(interp, slot, column))
		return false;
	if (interp->state.work_assigned)
		return fault(&interp->at, column,
			     "#%d cannot be read here: %s was changed by assignment while it was active; select it "
			     "again first",
			     number, state_system_name(state->system));
	if (state->tcp != TCP_OFF)
		return fault(&interp->at, column,
			     "reading #%d under tool centre point control is not supported", number);
	*value = program_position_value(state, slot);
	return true;
}

/* The work offset and the slot of #number; *system is -1 if the variable is no work offset. */
static bool find_work(struct interp *interp, int number, int column, int *system, int *slot)
{
	const struct macro_b_rules *rules = macro_b_of(interp)->rules;
	bool at_14001 = number >= 14001 && rules->work_at_14001 > 0;
	int first = at_14001 ? 14001 : number >= 7001 ? 7001 : 5221;
	int count = first == 5221 ? 6 : at_14001 ? rules->work_at_14001 : rules->work_at_7001;
	int row = number >= first ? (number - first) / WORK_STEP : count, place = (number - first) % WORK_STEP;

	*system = -1;
	if (number < first || row >= count || place >= WORK_SLOTS)
		return true;
	*system = first == 5221 ? row : SYSTEM_COUNT + row;
	return find_slot(interp, number, place, column, slot);
}

static bool fault_unknown(struct interp *interp, int number, int column)
{
	return fault(&interp->at, column, "system variable #%d is unknown here in the %s dialect", number,
		     interp->config->dialect->name);
}

/* The machine file must not give values that follow from the program and the setup. */
static bool check_untold(struct interp *interp, int number, int column)
{
	return !macro_b_kept_tells(interp, number) ||
	       fault(&interp->at, column,
		     "<variable name=\"#%d\"> is not allowed: the program and the setup determine this variable",
		     number);
}

/* The machine file gives the table as it is before the program starts: G10 changes it. */
static bool read_tool_offset(struct interp *interp, int number, int column, double *value)
{
	if (interp->tools.wear_count > 0)
		return fault(&interp->at, column,
			     "#%d, a tool offset of the control's table, cannot be read here after G10 L10 to L13 has "
			     "changed the table",
			     number);
	return macro_b_kept_read(interp, number, column, "is a tool offset of the control's table", value);
}

bool macro_b_system_read(struct interp *interp, int number, int column, double *value)
{
	const char *what = find_machine_only(macro_b_of(interp)->rules, number);
	int system, slot;

	if (number >= INPUT_FIRST && number <= INPUT_LAST)
		return macro_b_kept_read(interp, number, column,
					 "is the state of an input or output, which may change while the program runs; "
					 "if it stays the same",
					 value);
	if (is_tool_offset(number))
		return read_tool_offset(interp, number, column, value);
	if (what)
		return fault(&interp->at, column, "#%d (%s) is not known before the program runs", number,
			     what);
	if ((number >= 4001 && number <= 4030) || (number >= 4101 && number <= 4130))
		return check_untold(interp, number, column) && read_mode(interp, number, column, value);
	if (number >= 5001 && number < 5001 + SLOT_COUNT)
		return check_untold(interp, number, column) && read_position(interp, number, column, value);
	if (!find_work(interp, number, column, &system, &slot))
		return false;
	if (system < 0)
		return macro_b_kept_read(interp, number, column,
					 "is an unknown system variable; if it stays the same while the program runs",
					 value);
	if (!check_untold(interp, number, column) || !work_offset_use_require(interp, system, column))
		return false;
	*value = interp->state.work[system].v[slot] / unit_of(&interp->state, slot);
	return true;
}

/* ----------------------------------------------------------------- writing */

static bool write_work(struct interp *interp, int number, int column, double value)
{
	struct state *state = &interp->state;
	int system, slot;

	if (!find_work(interp, number, column, &system, &slot))
		return false;
	if (system < 0)
		return fault_unknown(interp, number, column);
	if (isnan(value))
		return fault(&interp->at, column, "#%d cannot be vacant", number);
	/* A change of the active offset takes effect at a time that depends on the control's read ahead. */
	if (system == state->system)
		interp->state.work_assigned = true;
	state->work[system].v[slot] = value * unit_of(state, slot);
	state->work_known[system] = true;
	return true;
}

bool macro_b_system_write(struct interp *interp, int number, int column, double value)
{
	switch (number) {
	case 3000:
		return fault(&interp->at, column, "#3000=%.15g stops the program with an alarm here", value);
	case 3001:
	case 3002:	/* clocks, which cannot be read here */
	case 3003:	/* single block, waiting for M functions: moves nothing */
	case 3006:	/* a stop with a message, like M0 */
		return true;
	case 3004:
		/* 1 disables feed hold, 2 the override, 4 the exact stop. */
		if (value < 4)
			return true;
		return fault(&interp->at, column, "#3004=%.15g switches exact stops off, which is not supported",
			     value);
	default:
		break;
	}
	if (number < 5221)
		return fault(&interp->at, column, "#%d cannot be assigned here in the %s dialect", number,
			     interp->config->dialect->name);
	return write_work(interp, number, column, value);
}
