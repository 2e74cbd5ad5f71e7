#include "gcode/text/block_letters.h"

#include <math.h>

/* Does the block call a subprogram or return from one (M97 to M99)? */
static bool is_call(const struct block *block, const struct dialect *dialect)
{
	return dialect->traits.call_letters && block->m[M_STOP] >= 97;
}

/* The words of canned cycles: execute/canned_cycle.c. */
static uint32_t cycle_letters(int code, const struct dialect *dialect)
{
	const struct cycle_traits *traits = dialect->traits.cycles;
	uint32_t used = letter_bit('R');

	/* canned_cycle.c then refuses the cycle, with the reason. */
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

/* The words of codes for path accuracy: execute/path_control.c. */
static uint32_t contour_letters(int code)
{
	return code == G5_1   ? letter_bit('Q') | letter_bit('R')
	       : code == G187 ? letter_bit('P') | letter_bit('E')
			      : letter_bit('P');
}

/* The points of a curve, and the order and weights of a NURBS: execute/spline_move.c, nurbs_move.c. */
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

/* The words of G10, including those of lathe tools, which execute/g10_tool_table.c refuses. */
static uint32_t data_letters(const struct block *block, const struct dialect *dialect)
{
	uint32_t used = letter_bit('L') | letter_bit('P') | letter_bit('R');
	double mode = block_has(block, 'L') ? block_value(block, 'L') : 0;

	if (dialect->traits.g10_writes_tools != ANSWER_NO && mode > 0 && mode < 12 &&
	    block_writes_tool_table((int)lround(mode)))
		used |= letter_bit('I') | letter_bit('J') | letter_bit('Q');
	return used;
}

/* M50 to M53 take a P for on or off, M48 and M49 do not. */
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

/* On controls where K repeats a canned cycle, L may do so, too: find_repeats in execute/canned_cycle.c. */
static uint32_t repeat_letters(const struct block *block, const struct dialect *dialect)
{
	const struct cycle_traits *cycles = dialect->traits.cycles;

	return cycles && cycles->repeat_letter == 'K' && !is_call(block, dialect) ? letter_bit('L') : 0;
}

static uint32_t motion_letters(const struct block *block, const struct dialect *dialect)
{
	switch (block->motion) {
	case CODE_NONE:
		return 0;
	case G2:
	case G3:
		return ARC_BITS | (dialect->traits.arcs_have_turns != ANSWER_NO ? letter_bit('P') : 0);
	case G33:
		return letter_bit('K');
	case G33_1:
		return letter_bits("IK");
	default:
		break;
	}
	/* Fanuc B-64484EN, "Multi-step Skip": the signals that stop the move. */
	if (block->motion >= G31 && block->motion <= G31_3)
		return letter_bit('P');
	return code_is_cycle(block->motion) ? cycle_letters(block->motion, dialect) | repeat_letters(block, dialect)
					    : spline_letters(block->motion);
}

static uint32_t nonmodal_letters(const struct block *block, const struct dialect *dialect)
{
	const struct dialect_traits *traits = &dialect->traits;

	switch (block->g[G_NONMODAL]) {
	case G4:
		return traits->dwell_letters ? letter_bits(traits->dwell_letters) : 0;
	case G10:
		return data_letters(block, dialect);
	case G12:
	case G13:
		return letter_bits("DIKLQ");
	case G22:
		return letter_bits("IJK");
	case G30:
		return traits->g30_has_number != ANSWER_NO ? letter_bit('P') : 0;
	/* The number of the solution: execute/coordinate_rotation.c. */
	case G53_1:
	case G53_6:
		return letter_bit('P');
	case G54_2:
	case G54_4:
		return letter_bit('P');
	case G70:
	case G71:
		return letter_bits("IJKL");
	case G150:
		return letter_bits("DIJKLPQR");
	default:
		return 0;
	}
}

/* Does the P of a block with G54 lie beyond the usual additional offsets, and another code take it? */
static bool leaves_number(const struct block *block, const struct dialect *dialect)
{
	return block_has(block, 'P') && block_value(block, 'P') > dialect->traits.shared_p &&
	       (is_call(block, dialect) ||
		((motion_letters(block, dialect) | nonmodal_letters(block, dialect)) & letter_bit('P')));
}

bool block_numbers_offset(const struct block *block, const struct dialect *dialect)
{
	const int system = block->g[G_SYSTEM];

	if (system == G54_1 || system == G154)
		return true;
	return system == G54 && dialect->traits.g54_has_number != ANSWER_NO && !leaves_number(block, dialect);
}

static uint32_t system_letters(const struct block *block, const struct dialect *dialect)
{
	return block_numbers_offset(block, dialect) ? letter_bit('P') : 0;
}

/* Including the words of forms that execute/coordinate_rotation.c refuses. */
static uint32_t rotation_letters(int rotation)
{
	if (code_tilts(rotation))
		return letter_bits("IJKRPQ");
	return rotation == G68 ? letter_bits("IJKR") : 0;
}

static uint32_t length_letters(int length)
{
	const bool has = length == G43 || length == G43_2 || length == G43_4 || length == G43_5 || length == G234;

	return has ? letter_bit('H') : 0;
}

/* L is the orientation of a lathe tool; only controls whose D is a tool have it. */
static uint32_t cutter_letters(int cutter, const struct dialect_traits *traits)
{
	if (cutter == CODE_NONE || cutter == G40)
		return 0;
	return traits->d_word == D_WORD_RADIUS ? letter_bit('D') : letter_bits("DL");
}

static uint32_t path_letters(const struct block *block, const struct dialect_traits *traits)
{
	return block->g[G_PATH] == G64 && traits->g64_has_tolerance != ANSWER_NO ? letter_bits("PQ") : 0;
}

/* M19 turns the spindle; its time is Q. */
static uint32_t spindle_letters(const struct block *block, const struct dialect_traits *traits)
{
	return block->m[M_SPINDLE] == 19 ? letter_bits(traits->m19_has_time == ANSWER_YES ? "PQR" : "PR") : 0;
}

/*
 * Words that another code may use, too: H and D alone; the directions of G43.5, which execute/tool_vector.c checks; the
 * words of M-codes that move nothing, unless a call has these words.
 */
static uint32_t idle_letters(const struct block *block, const struct dialect *dialect)
{
	const struct dialect_traits *traits = &dialect->traits;
	uint32_t used = (block->vectors ? letter_bits("IJKQ") : 0) | (traits->h_alone ? letter_bit('H') : 0) |
			(traits->d_alone == ANSWER_YES ? letter_bit('D') : 0);

	if (is_call(block, dialect))
		return used;
	if (block->m[M_COOLANT] == 8 && traits->m8_has_pressure == ANSWER_YES)
		used |= letter_bit('P');
	if (block->m_ignored)
		used |= letter_bits("PQ");
	/* Builders' M-codes take other words, too: M298 L1 of Brother. In a block that moves, they may be another's. */
	if (block->m_ignored && traits->call_letters && !(block->letters & AXIS_BITS))
		used |= letter_bits("ELR");
	return used;
}

int block_claims(const struct block *block, const struct dialect *dialect, struct block_claim claims[BLOCK_CLAIMS_MAX])
{
	const struct dialect_traits *traits = &dialect->traits;
	const int *g = block->g, *m = block->m;
	const struct block_claim all[BLOCK_CLAIMS_MAX] = {
	    {'G', g[G_SYSTEM], system_letters(block, dialect)},
	    {'G', g[G_ROTATION], rotation_letters(g[G_ROTATION])},
	    {'G', g[G_NONMODAL], nonmodal_letters(block, dialect)},
	    {'G', g[G_SCALING], g[G_SCALING] == G51 ? letter_bits("IJKP") : 0},
	    {'G', block->motion, motion_letters(block, dialect)},
	    {'G', g[G_LENGTH], length_letters(g[G_LENGTH])},
	    {'G', g[G_CUTTER], cutter_letters(g[G_CUTTER], traits)},
	    {'G', g[G_CONTOUR], g[G_CONTOUR] == CODE_NONE ? 0 : contour_letters(g[G_CONTOUR])},
	    {'G', g[G_PATH], path_letters(block, traits)},
	    {'G', g[G_SPINDLE], g[G_SPINDLE] == G96 ? letter_bit('D') : 0},
	    {'M', m[M_SPINDLE], spindle_letters(block, traits)},
	    {'M', m[M_OVERRIDE], override_letters(m[M_OVERRIDE])},
	    {'M', m[M_OUTPUT], output_letters(m[M_OUTPUT])},
	    {'M', m[M_TOOL], m[M_TOOL] == 61 ? letter_bit('Q') : 0},
	    {'M', m[M_STOP], is_call(block, dialect) ? letter_bits(traits->call_letters) : 0},
	    {'\0', CODE_NONE, AXIS_BITS | letter_bits("FST") | idle_letters(block, dialect)},
	};
	int count = 0;

	for (int i = 0; i < BLOCK_CLAIMS_MAX; i++) {
		if (all[i].letters & block->letters)
			claims[count++] = all[i];
	}
	return count;
}
