#include "gcode/dialect/dialects.h"
#include "gcode/dialect/fanuc/fanuc_family.h"
#include "gcode/dialect/fanuc/macro_b.h"
#include "gcode/dialect/fanuc/macro_b_call.h"
#include "gcode/dialect/fanuc/macro_b_state.h"
#include "gcode/dialect/haas/haas_macro.h"
#include "gcode/dialect/standard_codes.h"
#include "gcode/state.h"

/* Haas mill operator's manual, G-codes, M-codes. */
static const struct code g_codes[] = {
	{G12, G_NONMODAL, CODE_BOUNDED, "circular pocket milling, clockwise"},
	{G13, G_NONMODAL, CODE_BOUNDED, "circular pocket milling, counter-clockwise"},
	{350, GROUP_NONE, CODE_REFUSED, "tool diameter measurement"},
	{360, GROUP_NONE, CODE_REFUSED, "work offset measurement"},
	{G43_5, GROUP_NONE, CODE_REFUSED, "tool centre point control with tool vectors"},
	{470, GROUP_NONE, CODE_REFUSED, "text engraving (the letters belong to the control: post them as moves)"},
	{G53_1, GROUP_NONE, CODE_REFUSED, "tool axis direction control"},
	{G68_2, GROUP_NONE, CODE_REFUSED, "tilted working plane"},
	{G70, G_NONMODAL, CODE_READ, "bolt hole circle"},
	{G71, G_NONMODAL, CODE_READ, "bolt hole arc"},
	/* The manual does not say whether the first hole is at the present position. */
	{720, GROUP_NONE, CODE_REFUSED, "bolt holes along an angle (write X and Y of each hole)"},
	{G77, G_MOTION, CODE_BOUNDED, "back boring cycle"},
	{G100, G_MIRROR, CODE_READ, "end of mirror image"},
	{G101, G_MIRROR, CODE_READ, "mirror image"},
	{G103, G_CONTOUR, CODE_IGNORED, "limit of block look-ahead"},
	{1070, GROUP_NONE, CODE_REFUSED, "cylindrical mapping"},
	{1100, G_SYSTEM, CODE_READ, "additional work offset 1"},
	{1110, G_SYSTEM, CODE_READ, "additional work offset 2"},
	/* Mill operator's manual 96-8000: two of G110 to G129. In newer manuals the two codes are the interpolation. */
	{1120, GROUP_NONE, CODE_REFUSED,
	 "XY to XC interpolation (on older controls additional work offset 3: write G154 P3)"},
	{1130, GROUP_NONE, CODE_REFUSED,
	 "end of XY to XC interpolation (on older controls additional work offset 4: write G154 P4)"},
	{1140, G_SYSTEM, CODE_READ, "additional work offset 5"},
	{1150, G_SYSTEM, CODE_READ, "additional work offset 6"},
	{1160, G_SYSTEM, CODE_READ, "additional work offset 7"},
	{1170, G_SYSTEM, CODE_READ, "additional work offset 8"},
	{1180, G_SYSTEM, CODE_READ, "additional work offset 9"},
	{1190, G_SYSTEM, CODE_READ, "additional work offset 10"},
	{1200, G_SYSTEM, CODE_READ, "additional work offset 11"},
	{1210, G_SYSTEM, CODE_READ, "additional work offset 12"},
	{1220, G_SYSTEM, CODE_READ, "additional work offset 13"},
	{1230, G_SYSTEM, CODE_READ, "additional work offset 14"},
	{1240, G_SYSTEM, CODE_READ, "additional work offset 15"},
	{1250, G_SYSTEM, CODE_READ, "additional work offset 16"},
	{1260, G_SYSTEM, CODE_READ, "additional work offset 17"},
	{1270, G_SYSTEM, CODE_READ, "additional work offset 18"},
	{1280, G_SYSTEM, CODE_READ, "additional work offset 19"},
	{1290, G_SYSTEM, CODE_READ, "additional work offset 20"},
	{1360, GROUP_NONE, CODE_REFUSED, "work offset centre measurement"},
	{1410, GROUP_NONE, CODE_REFUSED, "3D cutter compensation"},
	{1430, GROUP_NONE, CODE_REFUSED, "5-axis tool length compensation"},
	{G150, G_NONMODAL, CODE_BOUNDED, "general purpose pocket milling"},
	{1530, GROUP_NONE, CODE_REFUSED, "five-axis high-speed peck drilling cycle"},
	{G154, G_SYSTEM, CODE_READ, "additional work offset"},
	{1550, GROUP_NONE, CODE_REFUSED, "five-axis reverse tapping cycle"},
	{1560, GROUP_NONE, CODE_REFUSED, "broaching cycle"},
	{1610, GROUP_NONE, CODE_REFUSED, "five-axis drilling cycle"},
	{1620, GROUP_NONE, CODE_REFUSED, "five-axis spot drilling cycle"},
	{1630, GROUP_NONE, CODE_REFUSED, "five-axis peck drilling cycle"},
	{1640, GROUP_NONE, CODE_REFUSED, "five-axis tapping cycle"},
	{1650, GROUP_NONE, CODE_REFUSED, "five-axis boring cycle"},
	{1660, GROUP_NONE, CODE_REFUSED, "five-axis boring cycle with a spindle stop"},
	{1690, GROUP_NONE, CODE_REFUSED, "five-axis boring cycle with a dwell"},
	{1740, GROUP_NONE, CODE_REFUSED, "rigid tapping in any direction, counter-clockwise"},
	{1840, GROUP_NONE, CODE_REFUSED, "rigid tapping in any direction"},
	{G187, G_CONTOUR, CODE_READ, "smoothness"},
	{1880, GROUP_NONE, CODE_REFUSED, "program of the pallet schedule"},
	{G234, G_LENGTH, CODE_READ, "tool centre point control"},
	{2530, GROUP_NONE, CODE_REFUSED, "spindle orientation to the feature coordinates (post with rotary words and "
					 "G254)"},
	{G254, G_DYNAMIC, CODE_READ, "dynamic work offset"},
	{G255, G_DYNAMIC, CODE_READ, "end of the dynamic work offset"},
	{2660, GROUP_NONE, CODE_REFUSED, "motion of visible axes"},
	{2680, GROUP_NONE, CODE_REFUSED, "feature coordinate system (post with rotary words and G254)"},
	{2690, GROUP_NONE, CODE_REFUSED, "cancelling of the feature coordinate system"},
};

static const struct code m_codes[] = {
	/* Haas mill operator's manual, M-codes: brakes of the rotary axes. */
	{10, GROUP_NONE, CODE_IGNORED, "brake of the fourth axis on"},
	{11, GROUP_NONE, CODE_IGNORED, "brake of the fourth axis off"},
	{12, GROUP_NONE, CODE_IGNORED, "brake of the fifth axis on"},
	{13, GROUP_NONE, CODE_IGNORED, "brake of the fifth axis off"},
	/*
	 * Haas: chip conveyor, gears; below, doors (M80, M81), the air jet (M83, M84), coolant through the spindle
	 * (M88, M89), pictures (M130, M131), mist (M158 to M163). M104 and M105 move the arm of the tool probe.
	 */
	{31, GROUP_NONE, CODE_IGNORED, "chip conveyor forward"},
	{33, GROUP_NONE, CODE_IGNORED, "chip conveyor stop"},
	{34, GROUP_NONE, CODE_REFUSED, "move of the coolant nozzle"},
	{35, GROUP_NONE, CODE_REFUSED, "move of the coolant nozzle"},
	{36, GROUP_NONE, CODE_IGNORED, "wait until the part of the pallet is ready"},
	{41, GROUP_NONE, CODE_IGNORED, "low gear"},
	{42, GROUP_NONE, CODE_IGNORED, "high gear"},
	{48, GROUP_NONE, CODE_IGNORED, "program check"},
	{49, GROUP_OUTPUT, CODE_IGNORED, "pallet status"},
	{50, GROUP_NONE, CODE_REFUSED, "pallet change"},
	/* M75, M78, M79: handling of the signal of G31; they move no axis. */
	{73, GROUP_NONE, CODE_IGNORED, "tool air blast on"},
	{74, GROUP_NONE, CODE_IGNORED, "tool air blast off"},
	{75, GROUP_NONE, CODE_IGNORED, "reference point of G35 or G136"},
	{78, GROUP_NONE, CODE_IGNORED, "alarm if a skip signal was received"},
	{79, GROUP_NONE, CODE_IGNORED, "alarm if no skip signal was received"},
	{80, GROUP_NONE, CODE_IGNORED, "door open"},
	{81, GROUP_NONE, CODE_IGNORED, "door closed"},
	{83, GROUP_NONE, CODE_IGNORED, "air jet on"},
	{84, GROUP_NONE, CODE_IGNORED, "air jet off"},
	{88, GROUP_NONE, CODE_IGNORED, "through-spindle coolant on"},
	{89, GROUP_NONE, CODE_IGNORED, "through-spindle coolant off"},
	{95, GROUP_NONE, CODE_IGNORED, "sleep"},
	{96, GROUP_NONE, CODE_REFUSED, "jump on an input"},
	{97, M_STOP, CODE_READ, "local subprogram call"},
	{104, GROUP_NONE, CODE_REFUSED, "motion of the probe arm"},
	{105, GROUP_NONE, CODE_REFUSED, "motion of the probe arm"},
	{109, GROUP_NONE, CODE_REFUSED, "operator input"},
	{130, GROUP_NONE, CODE_IGNORED, "display of a picture or video on"},
	{131, GROUP_NONE, CODE_IGNORED, "display of a picture or video off"},
	{138, GROUP_OUTPUT, CODE_IGNORED, "spindle speed variation on"},
	{139, GROUP_OUTPUT, CODE_IGNORED, "spindle speed variation off"},
	{158, GROUP_NONE, CODE_IGNORED, "mist condenser on"},
	{159, GROUP_NONE, CODE_IGNORED, "mist condenser off"},
	{160, GROUP_NONE, CODE_IGNORED, "pulsed oil mist off"},
	{161, GROUP_OUTPUT, CODE_IGNORED, "pulsed oil mist on"},
	{162, GROUP_OUTPUT, CODE_IGNORED, "pulsed oil mist on an event"},
	{163, GROUP_OUTPUT, CODE_IGNORED, "pulsed oil mist while feeding"},
};

/* Mill operator's manual, canned cycles. */
static const struct cycle_traits cycles = {
	FANUC_FAMILY_CYCLES,
	.axis_by_parameter = ANSWER_NO,
	.g87 = G87_BY_HAND,
	/* "G84 Tapping Canned Cycle". */
	.taps_retract_by_j = ANSWER_YES,
	.pecks_fall = ANSWER_YES,
	.shift_by_ij = ANSWER_YES,
	.repeat_letter = 'L',
};

/*
 * "G28 Return to Machine Zero": it cancels the length for the following lines. The manual does not say whether it does
 * so without Z, and how it affects G234.
 */
static void after_machine_move(struct interp *interp, int code, const bool moved[SLOT_COUNT])
{
	struct state *state = &interp->state;

	if (code == G53)
		return;
	if (code == G28 && moved[SLOT_Z] && state->tcp == TCP_OFF) {
		state->length = 0;
		state->length_code = G49;
		state_update_offset(state);
	} else if (code != DOUBT_M6 || moved[SLOT_Z] || state->tcp != TCP_OFF) {
		state->length_doubt = code;
	}
}

static void *new_state(void)
{
	return macro_b_state_new(&haas_macro_rules);
}

const struct dialect dialect_haas = {
	.name = "haas",
	.manual = "Haas mill operator's manual",
	.g_codes = {&standard_g_codes, &fanuc_family_g_codes, &(const struct code_set)CODE_SET(g_codes)},
	.m_codes = {&basic_m_codes, &standard_m_codes, &fanuc_family_m_codes,
		    &(const struct code_set)CODE_SET(m_codes)},
	.words = {&fanuc_family_words},
	.traits = {
		.last_of_group = ANSWER_NO,
		/* Parameters decide about units, distance mode and plane: the machine file has them. */
		/* Cutting mode: G64 is active at power-on. */
		.power_on = {.feed_mode = G94, .path = G64, .asks_motion = true},
		.whole_numbers = WHOLE_NUMBERS_INCREMENTS,
		.known_order = ANSWER_NO,
		/* G04: milliseconds without a decimal point. */
		.dwell_letters = "XUP",
		.dwell_p = DWELL_P_MILLISECONDS,
		.dwell_alone = ANSWER_YES,
		.text_before_percent = ANSWER_YES,
		.feed_forgotten = FEED_FORGOTTEN_BY_CHANGE,
		.empty_feed_move = EMPTY_FEED_MOVE_IGNORED,
		.feed_missing = FEED_MISSING_KEPT,
		.g64_has_tolerance = ANSWER_NO,
		.arc_centre = ARC_CENTRE_INCREMENTAL,
		.arc_without_centre = ARC_WITHOUT_CENTRE_REFUSED,
		.arc_idle_zero = ANSWER_YES,
		.arcs_have_turns = ANSWER_NO,
		/* "Corner Rounding and Chamfering". */
		.corner_words = CORNER_WORDS_WITH_LINES,
		.wrap_below_turn = ANSWER_NO,
		.cycles = &cycles,
		/* G-codes: cycles are group 09, G00 to G03 group 01, G28 and similar codes group 00. */
		.cycles_apart = ANSWER_YES,
		.motion_beside_words = ANSWER_YES,
		.g53_rate = G53_RATE_PROGRAMMED,
		.g53_under_tcp = G53_UNDER_TCP_AXES,
		.g53_asks_g91 = ANSWER_YES,
		.g53_alone = ANSWER_YES,
		.g28_without_axes = G28_WITHOUT_AXES_ALL,
		.references_in_parameters = ANSWER_NO,
		.g30_has_number = ANSWER_YES,
		/* "M08 Coolant On": for pumps with several pressures. */
		.m8_has_pressure = ANSWER_YES,
		/* The manual does not mention this. */
		.turned_by_machine = TURNED_BY_MACHINE_ACROSS,
		.t_word = T_WORD_SELECTS,
		/* "M06 Tool Change": M06 Tnn loads tool nn. */
		.m6_loads_own_t = ANSWER_YES,
		.tool_change_stays = ANSWER_NO,
		/* G154 P1 to P99; G110 to G129 are the first of them. */
		.additional_offsets = 99,
		.g54_has_number = ANSWER_NO,
		.g10_first = 1,
		.g10_last = 6,
		.g10_l20 = G10_L20_ADDITIONAL,
		/* G10: with G91 the words are added. */
		.g10_incremental = G10_INCREMENTAL_ADDS,
		.g10_writes_tools = ANSWER_NO,
		/* "G10 Set Offsets". */
		.g10_writes_registers = ANSWER_YES,
		.one_shift = ANSWER_NO,
		.shifts_ignore_g91 = ANSWER_NO,
		.h_missing = H_MISSING_REFUSED,
		.h_zero = H_ZERO_NONE,
		/* "G49 Cancel G43/G44/G143": H0 does the same. The manual does not say what any other H does. */
		.h_alone = H_ALONE_CANCELS,
		.d_alone = ANSWER_YES,
		.d_word = D_WORD_RADIUS,
		/* "Entry and Exit from Cutter Compensation". */
		.comp_waits = ANSWER_YES,
		.length_never_moves = ANSWER_NO,
		.g49_finds_length_gone = ANSWER_NO,
		.call_letters = "LP",
	},
	.after_machine_move = after_machine_move,
	.state_new = new_state,
	.state_free = macro_b_state_free,
	.statement = macro_b_line,
	.read_block = macro_b_read_block,
	.after_block = macro_b_call_after_block,
	.end_of_file = macro_b_call_end_of_file,
	.caller = macro_b_call_caller,
};
