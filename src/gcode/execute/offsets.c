#include "gcode/execute/offsets.h"

#include <math.h>

#include "base/same_double.h"
#include "gcode/execute/dynamic_work_offset.h"
#include "gcode/execute/g10_registers.h"
#include "gcode/execute/g10_tool_table.h"
#include "gcode/execute/probed_axes.h"
#include "gcode/execute/tool_length.h"
#include "gcode/execute/work_offset_use.h"
#include "gcode/text/block_letters.h"

/* The block's word for a slot, in mm or degrees. */
static bool slot_word(const struct interp *interp, int slot, double *value)
{
	char letter = AXIS_LETTERS[slot];

	if (!block_has(&interp->block, letter))
		return false;
	*value = block_value(&interp->block, letter) * (slot_is_rotary(slot) ? 1 : interp->state.scale);
	return true;
}

/* An additional work offset: G54.1 P1 and on, or G154 P1 and on. */
static bool find_additional(struct interp *interp, int code, int *system)
{
	int column = interp->block.g_column[G_SYSTEM], most = traits_of(interp)->additional_offsets, number = 0;

	if (!block_has(&interp->block, 'P'))
		return fault(&interp->at, column, "%s needs P", code == G154 ? "G154" : "G54.1");
	if (!is_answered(interp, column, most, "how many additional work offsets there are") ||
	    !block_integer(&interp->block, &interp->at, 'P', 1, most, &number))
		return false;
	*system = SYSTEM_COUNT + number - 1;
	return true;
}

static bool find_system(struct interp *interp, int code, int *system)
{
	const struct dialect_traits *traits = traits_of(interp);

	if (code == G54_1 || code == G154)
		return find_additional(interp, code, system);
	if (code == G54 && block_has(&interp->block, 'P') &&
	    block_numbers_offset(&interp->block, interp->config->dialect))
		return is_answered(interp, block_column(&interp->block, 'P'), traits->g54_has_number,
				   "whether G54 with P selects an additional work offset") &&
		       find_additional(interp, code, system);
	if (code >= G110 && code <= G129)
		*system = SYSTEM_COUNT + (code - G110) / 10;
	else
		*system = code <= G59 ? (code - G54) / 10 : 5 + code - G59;
	return true;
}

bool offsets_select(struct interp *interp)
{
	struct state *state = &interp->state;
	int code = interp->block.g[G_SYSTEM], column = interp->block.g_column[G_SYSTEM], system = state->system;

	if (code == CODE_NONE)
		return true;
	if (!find_system(interp, code, &system) || !dynamic_work_offset_check_system(interp, system))
		return false;
	if (!work_offset_use_require(interp, system, column))
		return false;
	state->system = system;
	return tool_length_offsets_changed(interp, column);
}

/* Manuals disagree about these codes in G91. */
static bool refuse_incremental(struct interp *interp)
{
	const struct block *block = &interp->block;
	int code = block->g[G_NONMODAL];
	bool same = code == G52;

	if (traits_of(interp)->shifts_ignore_g91 == ANSWER_YES || !interp->state.incremental)
		return true;
	/* G52 with 0 for an axis without a shift: this changes nothing, as an absolute value and as an increment. */
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (block_has(block, AXIS_LETTERS[slot]))
			same = same && same_double(block_value(block, AXIS_LETTERS[slot]), 0) &&
			       same_double(interp->state.shift.v[slot], 0);
	}
	if (same)
		return true;
	return fault(&interp->at, interp->block.g_column[G_NONMODAL],
		     "G%g in incremental mode (G91) is not supported", code / 10.0);
}

/*
 * Changes one slot. A change has two passes, rotary slots first: under TCP with rotary zero at the work offset they
 * change the position of the linear slots.
 */
typedef void change_slot(struct interp *interp, int system, int slot, double word);

/* These two compute the change from the present position. */
static change_slot change_work_here, change_shift_here;

static bool change_slots(struct interp *interp, int system, change_slot *change)
{
	int column = interp->block.g_column[G_NONMODAL];

	for (int rotary = 1; rotary >= 0; rotary--) {
		for (int slot = 0; slot < SLOT_COUNT; slot++) {
			double word;

			if (slot_is_rotary(slot) != rotary || !slot_word(interp, slot, &word))
				continue;
			if ((change == change_work_here || change == change_shift_here) &&
			    !probed_axes_is_known(interp, slot, block_column(&interp->block, AXIS_LETTERS[slot])))
				return false;
			change(interp, system, slot, word);
		}
		if (!tool_length_offsets_changed(interp, column))
			return false;
	}
	return true;
}

/* Fanuc 30i-B, changing workpiece coordinate system, and Haas, G10: with G91 the words are added. */
static void change_work(struct interp *interp, int system, int slot, double word)
{
	double *value = &interp->state.work[system].v[slot];
	bool added = interp->state.incremental && traits_of(interp)->g10_incremental == G10_INCREMENTAL_ADDS;

	*value = added ? *value + word : word;
}

/* The position with only this offset. */
static double position_without(const struct state *state, int slot, double offset)
{
	return state->position.v[slot] - (state->offset.v[slot] - offset);
}

/* Makes `word` the coordinate of the present point in the system, which need not be active. */
static void change_work_here(struct interp *interp, int system, int slot, double word)
{
	struct state *state = &interp->state;

	state->work[system].v[slot] = position_without(state, slot, state->work[state->system].v[slot]) - word;
}

/* The work offset that G10 L2 or L20 writes: L20 may write the additional offsets. */
static bool find_written(struct interp *interp, int mode, int *system)
{
	const struct block *block = &interp->block;
	const struct dialect_traits *traits = traits_of(interp);
	bool additional = mode == 20 && traits->g10_l20 == G10_L20_ADDITIONAL;
	int first = additional ? 1 : traits->g10_first,
	    last = additional ? traits->additional_offsets : traits->g10_last;
	int column = block_column(block, 'L');

	if (mode == 20 && !is_answered(interp, column, traits->g10_l20, "what G10 L20 writes"))
		return false;
	if (!is_answered(interp, column, last, "which work offsets G10 writes") ||
	    !block_integer(block, &interp->at, 'P', first, last, system))
		return false;
	if (additional)
		*system += SYSTEM_COUNT;
	*system = *system == 0 ? interp->state.system : *system - 1;
	return true;
}

static bool is_shifted(const struct state *state)
{
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!same_double(state->shift.v[slot], 0))
			return true;
	}
	return false;
}

/*
 * Fanuc B-64484EN, "Changing Workpiece Coordinate System": P0 is the offset that is added to all others. Haas, "G10 Set
 * Offsets": P0 is the offset of G52. Only values of 0 are supported.
 */
static bool clear_common(struct interp *interp)
{
	const struct block *block = &interp->block;
	double word;

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (slot_word(interp, slot, &word) && !same_double(word, 0))
			return fault(&interp->at, block_column(block, AXIS_LETTERS[slot]),
				     "G10 L2 P0 with values other than 0 shifts all work offsets, which is not "
				     "supported: write the sum into each of them by P1 to P%d",
				     traits_of(interp)->g10_last);
	}
	if (is_shifted(&interp->state))
		return fault(&interp->at, block_column(block, 'P'),
			     "G10 L2 P0 while G%d is active is not supported", interp->state.shift_code / 10);
	if (!interp->cautioned_common)
		caution(&interp->at, block_column(block, 'P'),
			"G10 L2 P0 clears the shift of all work offsets: the setup's work offsets are assumed not to "
			"contain it");
	interp->cautioned_common = true;
	return true;
}

/* Fanuc B-64484EN, "Programmable Parameter Input (G10)", "Tool Life Management": the next blocks write data. */
static bool check_data(struct interp *interp, int mode)
{
	const bool parameters = mode == 50 || mode == 52, life = mode == 3;

	if (traits_of(interp)->g10_writes_registers != ANSWER_YES || (!parameters && !life))
		return true;
	return fault(&interp->at, interp->block.g_column[G_NONMODAL],
		     "G10 L%d changes %s of the control, which %s not supported; check a copy of the program without "
		     "the blocks from G10 to G11",
		     mode, parameters ? "parameters" : "the tool life data", parameters ? "are" : "is");
}

/* LinuxCNC's manual, "G10 L2": R turns X and Y of a work offset about Z; R0 is usual and turns nothing. */
static bool turns_nothing(const struct interp *interp, int mode)
{
	return mode == 2 && traits_of(interp)->g10_writes_tools == ANSWER_YES &&
	       same_double(block_value(&interp->block, 'R'), 0);
}

/* LinuxCNC's manual, "G10 L2", "G10 L20"; Fanuc: only P1 to P6 of L2 mean the same; Haas, G10. */
bool offsets_set(struct interp *interp)
{
	const struct block *block = &interp->block;
	const struct dialect_traits *traits = traits_of(interp);
	bool tools = traits->g10_writes_tools == ANSWER_YES;
	int column = block->g_column[G_NONMODAL], mode, system;

	if (tools && block_has(block, 'L') && fabs(block_value(block, 'L')) < 0.5)
		return fault(&interp->at, block_column(block, 'L'),
			     "G10 L0 reloads the tool table, whose contents are not known");
	if (!block_has(block, 'L'))
		return fault(&interp->at, column, "G10 needs L and P");
	if (!block_integer(block, &interp->at, 'L', 0, 9999, &mode) || !check_data(interp, mode))
		return false;
	if (!block_has(block, 'P'))
		return fault(&interp->at, column, "G10 needs L and P");
	if (traits->g10_writes_registers == ANSWER_YES && g10_registers_take(mode))
		return g10_registers_write(interp, mode);
	if (tools && block_writes_tool_table(mode))
		return g10_tool_table_write(interp, mode);
	if (mode != 2 && mode != 20)
		return fault(&interp->at, block_column(block, 'L'), "G10 L%d is not supported", mode);
	if (block_has(block, 'R') && !turns_nothing(interp, mode))
		return fault(&interp->at, block_column(block, 'R'),
			     "G10 with R: rotation of a coordinate system is not supported");
	if (mode == 2 && traits->g10_first == 1 && same_double(block_value(block, 'P'), 0))
		return clear_common(interp);
	if (!find_written(interp, mode, &system))
		return false;
	if (interp->state.incremental && !is_answered(interp, column, traits->g10_incremental,
						      "whether G10 in incremental distance mode (G91) adds its words"))
		return false;
	interp->state.work_known[system] = true;
	return change_slots(interp, system,
			    mode == 20 && traits->g10_l20 == G10_L20_HERE ? change_work_here : change_work);
}

static void change_shift(struct interp *interp, int system, int slot, double word)
{
	(void)system;
	interp->state.shift.v[slot] = word;
}

static void change_shift_here(struct interp *interp, int system, int slot, double word)
{
	struct state *state = &interp->state;

	(void)system;
	state->shift.v[slot] = position_without(state, slot, state->shift.v[slot]) - word;
}

/* A code that gives the present position new coordinates needs a known tool length. False: reported. */
static bool check_place(struct interp *interp)
{
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (block_has(&interp->block, AXIS_LETTERS[slot]) &&
		    tool_length_is_in_doubt(interp, slot, block_column(&interp->block, AXIS_LETTERS[slot])))
			return false;
	}
	return true;
}

/*
 * Fanuc B-64484EN, "Workpiece Coordinate System Preset (G92.1)": cancels the shift of G52 and G92 of the axes that it
 * names, each with 0. Compensation must be cancelled before.
 */
static bool preset(struct interp *interp)
{
	struct state *state = &interp->state;
	const struct block *block = &interp->block;
	int column = block->g_column[G_NONMODAL];

	if (!(block->letters & AXIS_BITS))
		return fault(&interp->at, column, "G92.1 without an axis word");
	if (state->frame.on || state->tcp != TCP_OFF || interp->comp.side != 0 || !same_double(state->length, 0))
		return fault(
		    &interp->at, column,
		    "G92.1 in changed coordinates or with an active compensation (G41, G43) is not supported; write "
		    "G49 first");
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		char letter = AXIS_LETTERS[slot];

		if (block_has(block, letter) && !same_double(block_value(block, letter), 0))
			return fault(&interp->at, block_column(block, letter), "G92.1 presets an axis only to 0");
	}
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		state->shift.v[slot] = block_has(block, AXIS_LETTERS[slot]) ? 0 : state->shift.v[slot];
	state->saved_shift = state->shift;
	return tool_length_offsets_changed(interp, column);
}

/* LinuxCNC's manual, "G52", "G92": one shift for all nine systems, which both codes write. */
bool offsets_shift(struct interp *interp)
{
	struct state *state = &interp->state;
	int code = interp->block.g[G_NONMODAL], column = interp->block.g_column[G_NONMODAL];

	if (code == G92_1 && !is_answered(interp, column, traits_of(interp)->one_shift,
					  "whether G92.1 cancels the shift or presets coordinates"))
		return false;
	if (code == G92_1 && traits_of(interp)->one_shift == ANSWER_NO)
		return preset(interp);
	if (code == G92_1 || code == G92_2 || code == G92_3) {
		state->shift_applied = code == G92_3;
		state->shift = code == G92_3 ? state->saved_shift : (slot_values){{0}};
		if (code == G92_1)
			state->saved_shift = state->shift;
		return tool_length_offsets_changed(interp, column);
	}
	if (!refuse_incremental(interp))
		return false;
	if (traits_of(interp)->one_shift != ANSWER_YES && state->shift_code != code && is_shifted(state))
		return fault(&interp->at, column, "G%d while G%d is active is not supported", code / 10,
			     state->shift_code / 10);
	if ((code != G52 && !check_place(interp)) ||
	    !change_slots(interp, 0, code == G52 ? change_shift : change_shift_here))
		return false;
	state->shift_code = code;
	state->shift_applied = true;
	state->saved_shift = state->shift;
	return true;
}
