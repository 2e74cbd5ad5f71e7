#include "gcode/execute/tool_length.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>

#include "base/same_double.h"
#include "base/units.h"
#include "gcode/execute/coordinate_conversion.h"
#include "gcode/execute/length_change.h"
#include "gcode/read_on.h"

axis_values tool_length_rotary_zero(const struct interp *interp)
{
	axis_values zero = {{0}};

	if (!interp->config->controller.tcp_zero_offset)
		return zero;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		zero.v[slot] = radians(interp->state.offset.v[slot]);
	return zero;
}

/* Switches TCP and its length; the kinematics converts the present position. */
static bool switch_tcp(struct interp *interp, int column, enum tcp_source source, double length)
{
	struct state *state = &interp->state;
	struct kinematics_tcp tcp = {
	    .on = source != TCP_OFF, .length = length, .rotary_zero = tool_length_rotary_zero(interp)};
	axis_values position = state->canonical;

	if (!interp->kinematics->tcp(interp->kinematics->context, &tcp, line_loc(&interp->at, column), &position))
		return false;
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!slot_is_rotary(slot))
			state_set_position(state, slot, position.v[slot]);
	}
	state->tcp = source;
	state->length = length;
	state->rotary_zero = tcp.rotary_zero;
	state_update_offset(state);
	return true;
}

bool tool_length_switch_tcp(struct interp *interp, int column, enum tcp_source source)
{
	return switch_tcp(interp, column, source, interp->state.length);
}

bool tool_length_suspend(struct interp *interp, int column, struct suspended *suspended)
{
	struct state *state = &interp->state;

	*suspended = (struct suspended){state->tcp, state->frame.on};
	if (state->tcp == TCP_BY_MCODE && !is_answered(interp, column, traits_of(interp)->g53_under_tcp,
						       "what machine coordinates mean while an M-code has TCP on"))
		return false;
	if (state->tcp == TCP_BY_MCODE && traits_of(interp)->g53_under_tcp == G53_UNDER_TCP_TOOL_POINT)
		return fault(&interp->at, column,
			     "while an M-code has TCP on, this control takes machine coordinates as those of the tool "
			     "point; cancel TCP first");
	state->frame.on = false;
	return state->tcp == TCP_OFF || switch_tcp(interp, column, TCP_OFF, state->length);
}

bool tool_length_resume(struct interp *interp, int column, const struct suspended *suspended)
{
	interp->state.frame.on = suspended->frame;
	return suspended->tcp == TCP_OFF || switch_tcp(interp, column, suspended->tcp, interp->state.length);
}

/* Applies the machine file's answer for a length that may be cancelled; a cancelled length under TCP is not decided. */
static void answer_doubt(struct interp *interp)
{
	struct state *state = &interp->state;
	enum length_after_reference answer = interp->config->controller.length_after_reference;

	if (answer == LENGTH_AFTER_REFERENCE_UNKNOWN ||
	    (answer == LENGTH_AFTER_REFERENCE_GONE && state->tcp != TCP_OFF))
		return;
	state->length_doubt = CODE_NONE;
	if (answer == LENGTH_AFTER_REFERENCE_GONE) {
		state->length = 0;
		state_update_offset(state);
	}
}

void tool_length_after_machine(struct interp *interp, int code, const bool moved[SLOT_COUNT])
{
	struct state *state = &interp->state;
	const struct dialect *dialect = interp->config->dialect;
	bool any = false;

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		any = any || moved[slot];
	if (!any || (state->tcp == TCP_OFF && same_double(state->length, 0)))
		return;
	if (dialect->after_machine_move)
		dialect->after_machine_move(interp, code, moved);
	else
		state->length_doubt = code;
	if (state->length_doubt != CODE_NONE)
		answer_doubt(interp);
}

bool tool_length_is_in_doubt(struct interp *interp, int slot, int column)
{
	const struct state *state = &interp->state;

	if (state->length_doubt == CODE_NONE || (state->tcp == TCP_OFF && slot != SLOT_Z))
		return false;
	return !fault(&interp->at, column,
		      "%c%d may have cancelled the tool length compensation, so the position of %c depends on the "
		      "control; write G43, G43.4 or G49 again first%s",
		      state->length_doubt == DOUBT_M6 ? 'M' : 'G',
		      state->length_doubt == DOUBT_M6 ? 6 : state->length_doubt / 10, AXIS_LETTERS[slot],
		      state->tcp != TCP_OFF ? ""
					    : ", or set length_after_reference=\"keeps\" or \"cancels\" in the machine "
					      "file's <controller>");
}

bool tool_length_offsets_changed(struct interp *interp, int column)
{
	struct state *state = &interp->state;
	axis_values zero;
	bool changed = false;

	state_update_offset(state);
	if (state->tcp == TCP_OFF)
		return true;
	zero = tool_length_rotary_zero(interp);
	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		changed = changed || !same_double(zero.v[slot], state->rotary_zero.v[slot]);
	return !changed || switch_tcp(interp, column, state->tcp, state->length);
}

static bool find_spindle_length(struct interp *interp, int column, double *length)
{
	int number = interp->state.tool;
	const struct tool *tool = tool_table_find(&interp->tools, number);

	/* LinuxCNC's simulator takes the length of the former tool, the control that of the tool of M61. */
	if (interp->state.tool_by_m61)
		return fault(&interp->at, column,
			     "after M61, controls differ in the tool whose length G43 uses: write H%d", number);
	if (number != 0 && !tool)
		return fault(&interp->at, column,
			     "the length of T%d, the tool in the spindle, is not known; give it in the setup", number);
	*length = tool ? tool->length_offset : 0;
	return true;
}

/* The number of the length: the block's H, or the replacement of a missing H. 0: H0, or the tool in the spindle. */
static bool find_length_number(struct interp *interp, int *number)
{
	const struct block *block = &interp->block;
	enum h_missing missing = traits_of(interp)->h_missing;
	char code[16];

	if (block_has(block, 'H'))
		return block_integer(block, &interp->at, 'H', 0, INT_MAX, number);
	if (!is_answered(interp, block->g_column[G_LENGTH], missing, "which length G43 without H uses"))
		return false;
	*number = missing == H_MISSING_SPINDLE ? 0 : interp->state.length_number;
	snprintf(code, sizeof(code), "%g", block->g[G_LENGTH] / 10.0);
	if (missing == H_MISSING_REFUSED)
		return fault(&interp->at, block->g_column[G_LENGTH], "G%s needs H", code);
	if (*number < 0)
		return fault(&interp->at, block->g_column[G_LENGTH], "G%s needs H, and no earlier block has one",
			     code);
	return true;
}

/* The length of entry Hn of the table. */
static bool find_length(struct interp *interp, double *length)
{
	const struct block *block = &interp->block;
	const struct length_offset *entry;
	enum h_zero zero = traits_of(interp)->h_zero;
	int column = block_has(block, 'H') ? block_column(block, 'H') : block->g_column[G_LENGTH], number;

	if (!find_length_number(interp, &number))
		return false;
	interp->state.length_number = number;
	if (number == 0 && !is_answered(interp, column, zero, "which length H0 means"))
		return false;
	if (number == 0 && zero == H_ZERO_SPINDLE)
		return find_spindle_length(interp, column, length);
	*length = 0;
	if (number == 0)
		return true;
	entry = tool_table_length(&interp->tools, number);
	if (entry) {
		*length = entry->length;
		return true;
	}
	if (!interp->config->has_setup)
		return fault(&interp->at, column,
			     "H%d: no length offsets are defined, because there is no setup", number);
	return read_on_without(
	    interp, column,
	    "the setup defines no length offset H%d: add <offset number=\"%d\" length=\"\"/> with its value, or a "
	    "<tool> with this number",
	    number, number);
}

/*
 * LinuxCNC's manual, "G43.1 Dynamic Tool Length Offset", "G43.2 Apply additional Tool Length Offset": the offset is
 * given by axis words, or for G43.2 by the H of a tool. G43.1 replaces the active offset, G43.2 adds to it.
 */
static bool find_length_in_words(struct interp *interp, int code, double *length)
{
	const struct block *block = &interp->block;
	const bool adds = code == G43_2, by_axes = block->letters & AXIS_BITS;
	const double before = interp->state.length;

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		const char letter = AXIS_LETTERS[slot];

		if (slot != SLOT_Z && block_has(block, letter) && !same_double(block_value(block, letter), 0))
			return fault(&interp->at, block_column(block, letter),
				     "a tool offset in %c is not supported, only in Z", letter);
	}
	if (by_axes == (adds && block_has(block, 'H')))
		return fault(&interp->at, block->g_column[G_LENGTH],
			     adds ? "G43.2 needs either H or axis words" : "G43.1 needs an axis word");
	if (by_axes) {
		*length = block_has(block, 'Z') ? block_value(block, 'Z') * interp->state.scale + (adds ? before : 0)
						: before;
		return true;
	}
	if (!find_length(interp, length))
		return false;
	*length += before;
	return true;
}

/* Sets TCP and the length; no effect if they are already set. */
static bool set_tcp(struct interp *interp, int column, enum tcp_source source, double length)
{
	struct state *state = &interp->state;

	if (source != TCP_OFF || state->tcp != TCP_OFF)
		return (source == state->tcp && same_double(length, state->length)) ||
		       switch_tcp(interp, column, source, length);
	state->length = length;
	state_update_offset(state);
	return true;
}

/* Changes the length while TCP is on, if TCP is on before or after: then the change of length changes coordinates. */
static bool change_length(struct interp *interp, enum tcp_source source, double length, int doubt)
{
	struct state *state = &interp->state;
	enum tcp_source meanwhile = source == TCP_OFF ? state->tcp : source;
	int column = interp->block.g_column[G_LENGTH];
	struct length_change change = {.column = column, .doubt = doubt, .ends_tcp = meanwhile != source};
	slot_values before, after;

	if (traits_of(interp)->length_never_moves == ANSWER_YES)
		return set_tcp(interp, column, source, length);
	if (!set_tcp(interp, column, meanwhile, state->length))
		return false;
	before = length_change_place(interp);
	if (!set_tcp(interp, column, meanwhile, length))
		return false;
	after = length_change_place(interp);
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		change.shift.v[slot] = before.v[slot] - after.v[slot];
	return length_change_settle(interp, &change) && set_tcp(interp, column, source, length);
}

static bool is_taken_back(const struct interp *interp, int code, int doubt)
{
	return code == G49 && doubt != CODE_NONE && doubt != DOUBT_M6 && interp->state.tcp == TCP_OFF &&
	       traits_of(interp)->g49_finds_length_gone == ANSWER_YES;
}

/* H without a G-code of its group: H belongs to the active code, or is kept for the next code. */
static bool take_h_alone(struct interp *interp)
{
	struct block *block = &interp->block;
	struct state *state = &interp->state;
	enum h_alone h_alone = traits_of(interp)->h_alone;
	int column, number;

	bool cancelled = block->g[G_LENGTH] == G49;

	if (!block_has(block, 'H') || (block->g[G_LENGTH] != CODE_NONE && !cancelled) || h_alone == H_ALONE_UNKNOWN)
		return true;
	column = block_column(block, 'H');
	if (!block_integer(block, &interp->at, 'H', 0, INT_MAX, &number))
		return false;
	if (h_alone == H_ALONE_CANCELS && number != 0)
		return fault(&interp->at, column,
			     "H%d without G43: controls differ in whether it changes the length; write G43 H%d",
			     number, number);
	if (cancelled || state->length_code == G49) {
		state->length_number = number;
		return true;
	}
	block->g[G_LENGTH] = h_alone == H_ALONE_CANCELS ? G49 : state->length_code;
	block->g_column[G_LENGTH] = column;
	return true;
}

/*
 * Fanuc B-64484EN-2, "Tool Length Offset": by type A the length acts along Z, by type B across the plane, by type C
 * along the axis that the block names; Mitsubishi's controls do as by type C. They differ in G18 and G19, and where the
 * block names another linear axis alone, as programs for angle heads do.
 */
static bool check_length_axis(const struct interp *interp, int column, double length)
{
	const struct block *block = &interp->block;
	const struct state *state = &interp->state;
	const uint32_t others = block->letters & letter_bits("XYUVW");
	const bool alone = others && !(others & (others - 1)) && !block_has(block, 'Z');

	if (traits_of(interp)->length_axis_asked != ANSWER_YES ||
	    interp->config->controller.length_along_z == ANSWER_YES || (state->plane == G17 && !alone) ||
	    (same_double(length, 0) && same_double(state->length, 0)))
		return true;
	return fault(&interp->at, column,
		     "%s: a parameter of the control (5001#0 and #1) decides along which axis the tool length acts: if "
		     "always along Z, set tool_length_axis=\"z\" in the machine file's <controller>; other axes are "
		     "not supported",
		     alone ? "G43 with one axis other than Z" : "G43 in G18 or G19");
}

bool tool_length_select(struct interp *interp)
{
	const struct block *block = &interp->block;
	struct state *state = &interp->state;
	int code, column, doubt = state->length_doubt;
	enum tcp_source source = state->tcp;
	double length = 0;

	if (!take_h_alone(interp))
		return false;
	code = block->g[G_LENGTH];
	column = block->g_column[G_LENGTH];
	if (code == CODE_NONE)
		return true;
	state->length_doubt = CODE_NONE;
	state->length_code = code;
	/* Haas mill operator's manual, "G234 Tool Center Point Control"; G43.5: execute/tool_vector.h. */
	if (code == G234 || code == G43_5)
		code = G43_4;
	if (code != G49 &&
	    (!(code == G43_1 || code == G43_2 ? find_length_in_words(interp, code, &length)
					      : find_length(interp, &length)) ||
	     !coordinate_conversion_knows_length(interp, column, length)))
		return false;
	if (code == G43 && !check_length_axis(interp, column, length))
		return false;
	if (code == G43 && source == TCP_BY_LENGTH)
		return fault(&interp->at, column, "G43 while tool centre point control is on; write G49 first");
	if (code == G43_4 && source == TCP_BY_MCODE)
		return fault(&interp->at, column, "G43.4 while an M-code has TCP on; cancel TCP first");
	if (code == G43_4)
		source = TCP_BY_LENGTH;
	else if (source == TCP_BY_LENGTH)
		source = TCP_OFF;
	return is_taken_back(interp, code, doubt) ? set_tcp(interp, column, source, length)
						  : change_length(interp, source, length, doubt);
}

bool tool_length_mcode(struct interp *interp)
{
	const struct block *block = &interp->block;
	struct state *state = &interp->state;
	int column = block->m_column[M_TCP];

	if (block->m[M_TCP] == MCODE_TCP_ON && state->tcp == TCP_OFF)
		return switch_tcp(interp, column, TCP_BY_MCODE, state->length);
	if (block->m[M_TCP] == MCODE_TCP_OFF && state->tcp != TCP_OFF)
		return switch_tcp(interp, column, TCP_OFF, state->length);
	return true;
}
