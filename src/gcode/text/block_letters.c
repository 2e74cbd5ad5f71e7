#include "gcode/text/block_letters.h"

#include <math.h>

#include "gcode/execute/g10_tool_table.h"

bool block_is_call(const struct block *block, const struct dialect *dialect)
{
	return dialect->traits.call_letters && block->m[M_STOP] >= 97;
}

/* What the words of canned cycles are: execute/canned_cycle.c. */
static uint32_t cycle_letters(int code, const struct dialect *dialect)
{
	const struct cycle_traits *traits = dialect->traits.cycles;
	uint32_t used = letter_bit('R');

	/* canned_cycle.c refuses the cycle then, with the reason. */
	if (!traits || !traits->repeat_letter)
		return letter_bits("IJKLPQR");
	used |= letter_bit(traits->repeat_letter);
	if (code == G73 || code == G83)
		used |= letter_bit('Q') | (traits->pecks_fall == ANSWER_YES ? letter_bits("IJK") : 0);
	if (code == G74 || code == G82 || code == G84 || code == G86 || code == G89 ||
	    traits->p_is_needed != ANSWER_YES)
		used |= letter_bit('P');
	if (code == G74 || code == G84)
		used |= (traits->taps_peck == ANSWER_YES ? letter_bit('Q') : 0) |
			(traits->taps_retract_by_j == ANSWER_YES ? letter_bit('J') : 0);
	if (code == G87 && traits->g87 == G87_BACK_BY_IJK)
		used |= letter_bit('I') | letter_bit('J') | letter_bit('K');
	if (code == G76 || code == G77 || (code == G87 && traits->g87 == G87_BACK_BY_Q))
		used |= letter_bit('Q') | (traits->shift_by_ij == ANSWER_YES ? letter_bit('I') | letter_bit('J') : 0);
	return used;
}

/* How a control keeps to the path: execute/path_control.c. */
static uint32_t contour_letters(int code)
{
	return code == G5_1   ? letter_bit('Q') | letter_bit('R')
	       : code == G187 ? letter_bit('P') | letter_bit('E')
			      : letter_bit('P');
}

/* Points of the curve, and of a NURBS its order and the weights of its points: execute/spline_move.c, nurbs_move.c. */
static uint32_t spline_letters(int motion)
{
	switch (motion) {
	case G5:
		return letter_bits("IJPQ");
	case G5_1:
		return letter_bits("IJ");
	case G5_2:
		return letter_bits("LP");
	case G6_2:
		return letter_bits("KPR");
	default:
		return 0;
	}
}

/* What G10 sets, with the words of lathe tools, which execute/g10_tool_table.c refuses. */
static uint32_t data_letters(const struct block *block, const struct dialect *dialect)
{
	uint32_t used = letter_bit('L') | letter_bit('P') | letter_bit('R');
	double mode = block_has(block, 'L') ? block_value(block, 'L') : 0;

	if (dialect->traits.g10_writes_tools != ANSWER_NO && mode > 0 && mode < 12 &&
	    g10_tool_table_takes((int)lround(mode)))
		used |= letter_bit('I') | letter_bit('J') | letter_bit('Q');
	return used;
}

/* M50 to M53 take an on or off, M48 and M49 do not. */
static uint32_t override_letters(int code)
{
	return code >= 50 ? letter_bit('P') : 0;
}

/* M62 to M65 switch the output P, M67 and M68 set E to Q, M66 reads the input P or E in one of several ways. */
static uint32_t output_letters(int code)
{
	if (code == 66)
		return letter_bit('P') | letter_bit('E') | letter_bit('L') | letter_bit('Q');
	return code == CODE_NONE ? 0 : code < 66 ? letter_bit('P') : letter_bit('E') | letter_bit('Q');
}

/* Where K repeats a canned cycle, L may do so, too: find_repeats in execute/canned_cycle.c. */
static uint32_t repeat_letters(const struct block *block, const struct dialect *dialect)
{
	const struct cycle_traits *cycles = dialect->traits.cycles;

	return cycles && cycles->repeat_letter == 'K' && !block_is_call(block, dialect) ? letter_bit('L') : 0;
}

uint32_t block_used_letters(const struct block *block, const struct dialect *dialect)
{
	const struct dialect_traits *traits = &dialect->traits;
	uint32_t used = AXIS_BITS | letter_bit('F') | letter_bit('S') | letter_bit('T');

	if (block->motion == G2 || block->motion == G3) {
		used |= letter_bit('I') | letter_bit('J') | letter_bit('K') | letter_bit('R');
		used |= traits->arcs_have_turns != ANSWER_NO ? letter_bit('P') : 0;
	}
	if (block->motion != CODE_NONE && code_is_cycle(block->motion))
		used |= cycle_letters(block->motion, dialect) | repeat_letters(block, dialect);
	/* Fanuc B-64484EN, "Multi-step Skip": which signals are waited for. */
	if (block->motion >= G31 && block->motion <= G31_3)
		used |= letter_bit('P');
	used |= spline_letters(block->motion);
	if (block->motion == G33 || block->motion == G33_1)
		used |= letter_bit('K');
	if (block->motion == G33_1)
		used |= letter_bit('I');
	if (block->g[G_NONMODAL] == G4 && traits->dwell_letters)
		used |= letter_bits(traits->dwell_letters);
	if (block->g[G_NONMODAL] == G30 && traits->g30_has_number != ANSWER_NO)
		used |= letter_bit('P');
	if (block->g[G_NONMODAL] == G10)
		used |= data_letters(block, dialect);
	/* Which solution it takes: execute/coordinate_rotation.c. */
	if (block->g[G_NONMODAL] == G53_1 || block->g[G_NONMODAL] == G53_6)
		used |= letter_bit('P');
	if (block->g[G_CUTTER] != CODE_NONE && block->g[G_CUTTER] != G40)
		used |= letter_bit('D') | letter_bit('L');
	if (block->g[G_SYSTEM] == G54_1 || block->g[G_SYSTEM] == G154)
		used |= letter_bit('P');
	/* With those of the forms that execute/coordinate_rotation.c refuses. */
	if (block->g[G_ROTATION] == G68 || code_tilts(block->g[G_ROTATION]))
		used |= letter_bit('R') | letter_bit('I') | letter_bit('J') | letter_bit('K');
	if (block->g[G_NONMODAL] == G12 || block->g[G_NONMODAL] == G13)
		used |= letter_bits("DIKLQ");
	if (block->g[G_NONMODAL] == G150)
		used |= letter_bits("DIJKLPQR");
	if (block->g[G_SCALING] == G51)
		used |= letter_bits("IJKP");
	if (code_tilts(block->g[G_ROTATION]))
		used |= letter_bit('P') | letter_bit('Q');
	if (block->g[G_SYSTEM] == G54 && traits->g54_has_number != ANSWER_NO)
		used |= letter_bit('P');
	if (block->g[G_LENGTH] == G43 || block->g[G_LENGTH] == G43_4 || block->g[G_LENGTH] == G43_5 ||
	    block->g[G_LENGTH] == G234)
		used |= letter_bit('H');
	if (block->vectors)
		used |= letter_bits("IJKQ");
	if (block->g[G_NONMODAL] == G70 || block->g[G_NONMODAL] == G71)
		used |= letter_bits("IJKL");
	if (block->m[M_TOOL] == 61)
		used |= letter_bit('Q');
	used |= traits->h_alone ? letter_bit('H') : 0;
	used |= traits->d_alone == ANSWER_YES ? letter_bit('D') : 0;
	if (block->g[G_PATH] == G64 && traits->g64_has_tolerance != ANSWER_NO)
		used |= letter_bit('P') | letter_bit('Q');
	if (block->g[G_CONTOUR] != CODE_NONE)
		used |= contour_letters(block->g[G_CONTOUR]);
	if (block->g[G_SPINDLE] == G96)
		used |= letter_bit('D');
	if (block->m[M_SPINDLE] == 19)
		used |= letter_bit('P') | letter_bit('R');
	if (block->m_ignored)
		used |= letter_bit('P') | letter_bit('Q');
	/* Builders give their M-codes other words, too: M298 L1 of Brother. In a block that moves they may be another's. */
	if (block->m_ignored && traits->call_letters && !(block->letters & AXIS_BITS))
		used |= letter_bits("ELR");
	return used | override_letters(block->m[M_OVERRIDE]) | output_letters(block->m[M_OUTPUT]);
}
