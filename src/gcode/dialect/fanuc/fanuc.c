#include "gcode/dialect/dialects.h"
#include "gcode/dialect/fanuc/fanuc_family.h"
#include "gcode/dialect/fanuc/fanuc_macro.h"
#include "gcode/dialect/fanuc/macro_b.h"
#include "gcode/dialect/fanuc/macro_b_call.h"
#include "gcode/dialect/fanuc/macro_b_state.h"
#include "gcode/dialect/standard_codes.h"
#include "gcode/state.h"

/* Fanuc 30i-B operator's manual (B-64484EN), preparatory function. */
static const struct code g_codes[] = {
	{22, GROUP_NONE, CODE_REFUSED, "involute interpolation, clockwise"},
	{23, GROUP_NONE, CODE_REFUSED, "exponential function interpolation, clockwise"},
	{G2_4, G_MOTION, CODE_READ, "circular interpolation in space, through a point"},
	{32, GROUP_NONE, CODE_REFUSED, "involute interpolation, counter-clockwise"},
	{33, GROUP_NONE, CODE_REFUSED, "exponential function interpolation, counter-clockwise"},
	{G3_4, G_MOTION, CODE_READ, "circular interpolation in space, through a point, as G2.4"},
	{G5, G_CONTOUR, CODE_READ, "high-speed machining (P10000) and smoothing"},
	{G5_1, G_CONTOUR, CODE_READ, "AI contour control, smooth interpolation, nano smoothing"},
	{54, GROUP_NONE, CODE_REFUSED, "high-speed high-precision contouring"},
	{61, GROUP_NONE, CODE_REFUSED, "spline interpolation"},
	{G6_2, G_MOTION, CODE_BOUNDED, "NURBS interpolation"},
	{G7_1, G_NONMODAL, CODE_BOUNDED, "cylindrical interpolation"},
	{G8, G_CONTOUR, CODE_READ, "AI advanced preview control"},
	{106, GROUP_NONE, CODE_REFUSED, "tool retract and recover"},
	{110, GROUP_NONE, CODE_IGNORED, "end of data setting"},
	{G12_1, G_NONMODAL, CODE_BOUNDED, "polar coordinate interpolation"},
	{G13_1, G_NONMODAL, CODE_READ, "end of polar coordinate interpolation"},
	{G15, G_POLAR, CODE_READ, "end of polar coordinates"},
	{G16, G_POLAR, CODE_READ, "polar coordinate command"},
	/* B-64484EN-2, "Stored Stroke Check": the zone stops the machine with an alarm, and moves no axis. */
	{G22, G_NONMODAL, CODE_IGNORED, "stored stroke check"},
	{230, GROUP_NONE, CODE_IGNORED, "end of the stored stroke check"},
	{250, GROUP_NONE, CODE_IGNORED, "end of spindle speed fluctuation detection"},
	{260, GROUP_NONE, CODE_IGNORED, "spindle speed fluctuation detection"},
	{270, GROUP_NONE, CODE_REFUSED, "reference position check"},
	{311, G_MOTION, CODE_BOUNDED, "multi-step skip"},
	{312, G_MOTION, CODE_BOUNDED, "multi-step skip"},
	{G31_3, G_MOTION, CODE_BOUNDED, "multi-step skip"},
	{G33, GROUP_NONE, CODE_REFUSED, "thread cutting"},
	{401, GROUP_NONE, CODE_IGNORED, "end of normal direction control"},
	{411, GROUP_NONE, CODE_REFUSED, "normal direction control, left"},
	{412, GROUP_NONE, CODE_REFUSED, "three-dimensional cutter compensation, left"},
	{421, GROUP_NONE, CODE_REFUSED, "normal direction control, right"},
	{422, GROUP_NONE, CODE_REFUSED, "three-dimensional cutter compensation, right"},
	{431, GROUP_NONE, CODE_REFUSED, "tool length compensation in the tool axis direction"},
	{G43_5, G_LENGTH, CODE_READ, "tool centre point control with tool vectors"},
	{450, GROUP_NONE, CODE_REFUSED, "tool offset, extension by D"},
	{460, GROUP_NONE, CODE_REFUSED, "tool offset, reduction by D"},
	{470, GROUP_NONE, CODE_REFUSED, "tool offset, extension by twice D"},
	{480, GROUP_NONE, CODE_REFUSED, "tool offset, reduction by twice D"},
	{G50_1, G_MIRROR, CODE_READ, "end of mirror image"},
	{502, GROUP_NONE, CODE_IGNORED, "end of polygon turning"},
	{G51_1, G_MIRROR, CODE_READ, "mirror image"},
	{512, GROUP_NONE, CODE_REFUSED, "polygon turning"},
	{G53_1, G_NONMODAL, CODE_READ, "tool axis direction control"},
	{G53_6, G_NONMODAL, CODE_READ, "tool axis direction control that keeps the tool tip in place"},
	{G54_2, G_NONMODAL, CODE_READ, "end of the rotary table dynamic fixture offset (P0); any other P is an error"},
	{G54_4, G_NONMODAL, CODE_READ, "work setting error compensation (only with values of 0)"},
	/* On controls that read the same programs (Mazak, Mitsubishi). Fanuc stops with an alarm. */
	{G61_1, G_PATH, CODE_READ, "high-accuracy control"},
	/* Cutting feed functions: like G64 they do not stop at corners. */
	{G62, G_PATH, CODE_READ, "automatic corner override"},
	{G63, G_PATH, CODE_READ, "tapping mode"},
	{660, GROUP_STATEMENT, CODE_READ, "modal macro call"},
	{661, GROUP_NONE, CODE_REFUSED, "modal macro call at every block"},
	{670, GROUP_STATEMENT, CODE_READ, "end of modal macro calls"},
	{G68_2, G_ROTATION, CODE_READ, "tilted working plane"},
	{683, GROUP_NONE, CODE_REFUSED, "tilted working plane from the tool direction (write the plane as G68.2)"},
	{G68_4, G_ROTATION, CODE_READ, "tilted working plane relative to a tilted plane"},
	/* B-64604EN-1, operator's manual of lathes, multiple repetitive cycles; Sinumerik, units. */
	{700, GROUP_NONE, CODE_REFUSED, "lathe finishing cycle (for inches write G20)"},
	{710, GROUP_NONE, CODE_REFUSED, "lathe turning cycle (for millimetres write G21)"},
	{720, GROUP_NONE, CODE_REFUSED, "lathe facing cycle"},
	{721, GROUP_NONE, CODE_REFUSED, "rotation copy"},
	{722, GROUP_NONE, CODE_REFUSED, "linear copy"},
	{811, GROUP_NONE, CODE_REFUSED, "chopping"},
	/* B-63534EN, program format of Series 15, and Mazak: "Rigid Tapping". */
	{842, G_MOTION, CODE_READ, "rigid tapping cycle, as G84"},
	{843, G_MOTION, CODE_READ, "left-hand rigid tapping cycle, as G74"},
	/* By posts for several controls: I, J and K are always relative here. Fanuc stops with an alarm. */
	{911, G_ARC_DISTANCE, CODE_READ, "incremental arc centres"},
	{G92_1, G_NONMODAL, CODE_READ, "workpiece coordinate system preset"},
	{G96, GROUP_NONE, CODE_REFUSED, "constant surface speed"},
	/* The mode that is always active here. */
	{970, G_SPINDLE, CODE_READ, "spindle speed in revolutions per minute"},
	{1070, G_NONMODAL, CODE_BOUNDED, "cylindrical interpolation"},
	{1120, G_NONMODAL, CODE_BOUNDED, "polar coordinate interpolation"},
	{1130, G_NONMODAL, CODE_READ, "end of polar coordinate interpolation"},
};

static const struct code m_codes[] = {
	/* B-63944EN, rigid tapping: M29, unless parameter 5210 gives it another number. */
	{29, GROUP_NONE, CODE_IGNORED, "rigid tapping mode"},
	{198, GROUP_NONE, CODE_REFUSED, "subprogram call from another memory"},
};

/* B-63944EN, custom macro. */
static const struct code_word words[] = {
	{"SETVN", CODE_IGNORED, "names of common variables; a program that uses such a name is refused"},
};

/*
 * 30i-B operator's manual, canned cycles for drilling: drilling data stay valid from one cycle to the next, and the
 * control starts the spindle.
 */
static const struct cycle_traits cycles = {
	FANUC_FAMILY_CYCLES,
	/* B-63534EN, "Canned cycle": with parameter 5101#0 (FXY) at 0, Z drills in every plane. */
	.axis_by_parameter = ANSWER_YES,
	.g87 = G87_BACK_BY_Q,
	.taps_peck = ANSWER_YES,
	.pecks_fall = ANSWER_NO,
	.shift_by_ij = ANSWER_NO,
	.repeat_letter = 'K',
};

/*
 * 0i-MB operator's manual (B-63844EN), "G53, G28, and G30 commands in tool length offset mode": these codes cancel the
 * length of an axis that they move; parameter 5001#6 (EVO) decides whether the length is restored automatically or by
 * the next G43 or H. A tool change at a fixed position may use such codes.
 */
static void after_machine_move(struct interp *interp, int code, const bool moved[SLOT_COUNT])
{
	if (moved[SLOT_Z] || interp->state.tcp != TCP_OFF)
		interp->state.length_doubt = code;
}

static void *new_state(void)
{
	return macro_b_state_new(&fanuc_macro_rules);
}

const struct dialect dialect_fanuc = {
	.name = "fanuc",
	.manual = "Fanuc 30i-B operator's manual (B-64484EN)",
	.g_codes = {&standard_g_codes, &fanuc_family_g_codes, &(const struct code_set)CODE_SET(g_codes)},
	.m_codes = {&basic_m_codes, &standard_m_codes, &fanuc_family_m_codes,
		    &(const struct code_set)CODE_SET(m_codes)},
	.words = {&fanuc_family_words, &(const struct word_set){words, sizeof(words) / sizeof(*words)}},
	.traits = {
		/* B-64484EN, "Preparatory Function": of one group in one block the last one is valid. */
		.last_of_group = ANSWER_YES,
		/* Parameters decide about units, distance mode and plane: the machine file has them. */
		/* Cutting mode: G64 is active at power-on. */
		.power_on = {.feed_mode = G94, .path = G64, .asks_motion = true},
		.whole_numbers = WHOLE_NUMBERS_INCREMENTS,
		.known_order = ANSWER_NO,
		.dwell_letters = "XUP",
		.dwell_p = DWELL_P_MILLISECONDS,
		.dwell_alone = ANSWER_YES,
		.text_before_percent = ANSWER_YES,
		.feed_forgotten = FEED_FORGOTTEN_BY_CHANGE,
		.empty_feed_move = EMPTY_FEED_MOVE_IGNORED,
		.feed_missing = FEED_MISSING_KEPT,
		.g64_has_tolerance = ANSWER_NO,
		.arc_centre = ARC_CENTRE_INCREMENTAL,
		/* Parameter 3403#5 (CIR): a line, or alarm PS0022. */
		.arc_without_centre = ARC_WITHOUT_CENTRE_LINE,
		/* "Circular Interpolation (G02, G03)": R takes precedence; the end need not be on the arc. */
		.arc_radius_wins = ANSWER_YES,
		.arc_spirals = ANSWER_YES,
		.arc_idle_zero = ANSWER_YES,
		/* B-63944EN-2, "Tool Movement in Offset Mode": of N blocks that are read, N - 2 may have no move. */
		.idle_blocks_parameter = "19625, less 2",
		.arcs_have_turns = ANSWER_NO,
		/* "Optional Chamfering and Corner R". */
		.corner_words = CORNER_WORDS_WITH_ARCS,
		.wrap_below_turn = ANSWER_NO,
		.cycles = &cycles,
		/* G code list: cycles are group 09, G0 to G3 group 01, G28 and similar codes group 00. */
		.cycles_apart = ANSWER_YES,
		.motion_beside_words = ANSWER_YES,
		/* Machine coordinate system (G53). */
		.g53_rate = G53_RATE_RAPID,
		.g53_under_tcp = G53_UNDER_TCP_AXES,
		/* B-64484EN, "Machine Coordinate System (G53)": G53 is ignored in G91. Not all such controls do so. */
		.g53_asks_g91 = ANSWER_YES,
		.g53_alone = ANSWER_YES,
		/* An alarm. */
		.g28_without_axes = G28_WITHOUT_AXES_REFUSED,
		.references_in_parameters = ANSWER_NO,
		.g30_has_number = ANSWER_YES,
		/* 16-C operator's manual (B-62764EN), "Coordinate system rotation". */
		.turned_by_machine = TURNED_BY_MACHINE_REFUSED,
		/* The same, "Three-dimensional coordinate conversion". */
		.g68_in_space = ANSWER_YES,
		.t_word = T_WORD_SELECTS,
		/* B-64484EN, "Tool Function": T and M reach the builder's ladder program at the same time. */
		.m6_loads_own_t = ANSWER_NO,
		.tool_change_stays = ANSWER_NO,
		/* G54.1 P1 to P48, or to P300 as an option; G54 with P is the same. */
		.additional_offsets = EXTENDED_COUNT,
		.shared_p = 48,
		.g54_has_number = ANSWER_YES,
		.g10_first = 1,
		.g10_last = 6,
		.g10_l20 = G10_L20_ADDITIONAL,
		/* Changing workpiece coordinate system: with G91 the words are added. */
		.g10_incremental = G10_INCREMENTAL_ADDS,
		.g10_writes_tools = ANSWER_NO,
		/* B-64484EN, "Tool Compensation Values ... and Entering Values from the Program (G10)": memory C. */
		.g10_writes_registers = ANSWER_YES,
		.one_shift = ANSWER_NO,
		.shifts_ignore_g91 = ANSWER_NO,
		/* H is modal data (C Executer manual B-62443EN-3, reading modal data). */
		.h_missing = H_MISSING_LAST,
		.h_zero = H_ZERO_NONE,
		/* B-64484EN, "Tool Length Offset": the length changes with H; cutter compensation: D is modal. */
		.h_alone = H_ALONE_CHANGES,
		.d_alone = ANSWER_YES,
		.d_word = D_WORD_RADIUS,
		/* "Start-up", type C (parameter 5003#1, SUV): the tool moves aside at once. */
		.comp_waits = ANSWER_NO,
		/* "Tool Length Offset": types A, B and C, parameter 5001#0 (TLC) and #1 (TLB). */
		.length_axis_asked = ANSWER_YES,
		.length_never_moves = ANSWER_NO,
		/* B-63844EN, see after_machine_move. */
		.g49_finds_length_gone = ANSWER_YES,
		.call_letters = "LPQ",
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
