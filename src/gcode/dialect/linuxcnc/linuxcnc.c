#include "gcode/dialect/dialects.h"
#include "gcode/dialect/linuxcnc/control_flow.h"
#include "gcode/dialect/linuxcnc/linuxcnc_expr.h"
#include "gcode/dialect/linuxcnc/linuxcnc_state.h"
#include "gcode/dialect/linuxcnc/system_params.h"
#include "gcode/dialect/standard_codes.h"
#include "gcode/state.h"

/* LinuxCNC's manual, "G-Codes", "M-Codes". */
static const struct code g_codes[] = {
	/* LinuxCNC follows splines by arcs between points of the curve: spline.h. */
	{G5, G_MOTION, CODE_BOUNDED, "cubic spline"},
	{G5_1, G_MOTION, CODE_BOUNDED, "quadratic spline"},
	{G5_2, G_MOTION, CODE_BOUNDED, "NURBS block"},
	{G5_3, G_MOTION, CODE_BOUNDED, "end of the NURBS block"},
	{60, GROUP_NONE, CODE_REFUSED, "NURBS block"},
	{61, GROUP_NONE, CODE_REFUSED, "NURBS block"},
	{62, GROUP_NONE, CODE_REFUSED, "NURBS block"},
	{63, GROUP_NONE, CODE_REFUSED, "NURBS block"},
	{70, GROUP_NONE, CODE_REFUSED, "lathe diameter mode"},
	{80, GROUP_NONE, CODE_REFUSED, "lathe radius mode"},
	{171, GROUP_NONE, CODE_REFUSED, "arc plane of U V W"},
	{181, GROUP_NONE, CODE_REFUSED, "arc plane of U V W"},
	{191, GROUP_NONE, CODE_REFUSED, "arc plane of U V W"},
	{G28_1, G_NONMODAL, CODE_READ, "storing of the reference position"},
	{G30_1, G_NONMODAL, CODE_READ, "storing of the second reference position"},
	{G33, G_MOTION, CODE_READ, "spindle-synchronized motion"},
	{G33_1, G_MOTION, CODE_READ, "rigid tapping"},
	{G38_2, G_MOTION, CODE_BOUNDED, "probing toward the workpiece, with an error"},
	{G38_3, G_MOTION, CODE_BOUNDED, "probing toward the workpiece"},
	{G38_4, G_MOTION, CODE_BOUNDED, "probing away from the workpiece, with an error"},
	{G38_5, G_MOTION, CODE_BOUNDED, "probing away from the workpiece"},
	{G41, G_CUTTER, CODE_READ, "cutter compensation, left of the path"},
	{G41_1, G_CUTTER, CODE_READ, "dynamic cutter compensation, left of the path"},
	{G42, G_CUTTER, CODE_READ, "cutter compensation, right of the path"},
	{G42_1, G_CUTTER, CODE_READ, "dynamic cutter compensation, right of the path"},
	{G43_1, G_LENGTH, CODE_READ, "dynamic tool length offset"},
	{G43_2, G_LENGTH, CODE_READ, "additional tool length offset"},
	{591, G_SYSTEM, CODE_READ, "work offset 7"},
	{592, G_SYSTEM, CODE_READ, "work offset 8"},
	{593, G_SYSTEM, CODE_READ, "work offset 9"},
	{G61_1, G_PATH, CODE_READ, "exact stop"},
	{700, GROUP_NONE, CODE_REFUSED, "lathe finishing cycle"},
	{710, GROUP_NONE, CODE_REFUSED, "lathe roughing cycle"},
	{711, GROUP_NONE, CODE_REFUSED, "lathe roughing cycle"},
	{712, GROUP_NONE, CODE_REFUSED, "lathe roughing cycle"},
	{720, GROUP_NONE, CODE_REFUSED, "lathe facing cycle"},
	{721, GROUP_NONE, CODE_REFUSED, "lathe facing cycle"},
	{722, GROUP_NONE, CODE_REFUSED, "lathe facing cycle"},
	{760, GROUP_NONE, CODE_REFUSED, "multi-pass threading cycle"},
	{G87, G_MOTION, CODE_READ, "back boring cycle, or boring cycle with a retract by hand"},
	{G88, GROUP_NONE, CODE_REFUSED, "boring cycle in which the operator retracts the tool by hand"},
	{G90_1, G_ARC_DISTANCE, CODE_READ, "absolute arc centres"},
	{911, G_ARC_DISTANCE, CODE_READ, "incremental arc centres"},
	{G92_1, G_NONMODAL, CODE_READ, "end of the coordinate system shift"},
	{G92_2, G_NONMODAL, CODE_READ, "suspension of the coordinate system shift"},
	{G92_3, G_NONMODAL, CODE_READ, "return of the coordinate system shift"},
	{G96, G_SPINDLE, CODE_READ, "constant surface speed"},
	/* The mode that is always active here. */
	{970, G_SPINDLE, CODE_READ, "spindle speed in revolutions per minute"},
};

/* No codes of LinuxCNC itself: machines with switched kinematics get them by a remap. */
static const struct code remapped_g_codes[] = {
	{G43_4, G_LENGTH, CODE_READ, "tool centre point control"},
	{G43_5, GROUP_NONE, CODE_REFUSED, "tool centre point control with tool vectors"},
};

/* No codes of LinuxCNC either: posts for PathPilot (Tormach) and Mach3 begin each program with G50 or G69. */
static const struct code mach3_g_codes[] = {
	{G50, G_SCALING, CODE_IGNORED, "end of scaling (PathPilot, Mach3)"},
	{G51, GROUP_NONE, CODE_REFUSED, "scaling (PathPilot, Mach3)"},
	{G68, GROUP_NONE, CODE_REFUSED, "coordinate rotation (PathPilot, Mach3)"},
	{G69, G_ROTATION, CODE_IGNORED, "end of coordinate rotation (PathPilot, Mach3)"},
};

static const struct code_set remapped_set =
	CODE_SET_OF(remapped_g_codes, "Fanuc 30i-B operator's manual (B-64484EN); LinuxCNC itself has no such code");
static const struct code_set mach3_set =
	CODE_SET_OF(mach3_g_codes, "manuals of PathPilot and Mach3; LinuxCNC itself has no such code");

static const struct code m_codes[] = {
	{19, M_SPINDLE, CODE_READ, "spindle orientation"},
	/* LinuxCNC's manual, "M-Codes": overrides and outputs change speeds and signals, and move no axis. */
	{48, M_OVERRIDE, CODE_IGNORED, "speed and feed overrides on"},
	{49, M_OVERRIDE, CODE_IGNORED, "speed and feed overrides off"},
	{50, M_OVERRIDE, CODE_IGNORED, "feed override control"},
	{51, M_OVERRIDE, CODE_IGNORED, "spindle speed override control"},
	{52, M_OVERRIDE, CODE_IGNORED, "adaptive feed control"},
	{53, M_OVERRIDE, CODE_IGNORED, "feed stop control"},
	{61, M_TOOL, CODE_READ, "setting of the current tool number"},
	{62, M_OUTPUT, CODE_IGNORED, "digital output on, with the next motion"},
	{63, M_OUTPUT, CODE_IGNORED, "digital output off, with the next motion"},
	{64, M_OUTPUT, CODE_IGNORED, "digital output on"},
	{65, M_OUTPUT, CODE_IGNORED, "digital output off"},
	{66, M_OUTPUT, CODE_IGNORED, "wait for an input; reading #5399 is an error"},
	{67, M_OUTPUT, CODE_IGNORED, "analog output, with the next motion"},
	{68, M_OUTPUT, CODE_IGNORED, "analog output"},
	{70, M_MODES, CODE_READ, "saving of the modal state"},
	{71, M_MODES, CODE_READ, "invalidation of the saved modal state"},
	{72, M_MODES, CODE_READ, "restoring of the modal state"},
	{73, M_MODES, CODE_READ, "saving of the modal state, restored at the end of the subprogram"},
	/* The call of a subprogram by its number is read before the block. */
	{98, GROUP_STATEMENT, CODE_READ, "subprogram call"},
};

/* LinuxCNC's manual, "Parameters", "O Codes". */
static const struct code_word words[] = {
	{"#n =", CODE_READ,
	 "parameter, as #number or #<name>; reading a value that only the machine knows is an error"},
	{"O... SUB", CODE_READ, "subroutine up to ENDSUB; RETURN leaves it"},
	{"O... CALL", CODE_READ, "call of a subroutine, or of its file"},
	{"O... IF", CODE_READ, "condition, with ELSEIF, ELSE and ENDIF"},
	{"O... WHILE", CODE_READ, "loop up to ENDWHILE; also DO, BREAK and CONTINUE"},
	{"O... REPEAT", CODE_READ, "loop up to ENDREPEAT"},
};

/* LinuxCNC's manual, "Canned Cycles", and its 2.9 interpreter (interp_cycles.cc). */
static const struct cycle_traits cycles = {
	.words_outlive_cycle = ANSWER_NO,
	.words_keep_place = ANSWER_NO,
	.without_axes = ANSWER_NO,
	.starts_at_r = ANSWER_YES,
	.never_below_r = ANSWER_YES,
	.level_is_coordinate = ANSWER_YES,
	.p_is_needed = ANSWER_YES,
	.q_has_sign = ANSWER_YES,
	.zero_repeats_refused = ANSWER_YES,
	.only_xyz = ANSWER_YES,
	.spindle_must_turn = ANSWER_YES,
	.axis_by_parameter = ANSWER_NO,
	/* Up to version 2.9 it exchanges the coordinates of taps for the plane twice. */
	.taps_confuse_planes = ANSWER_YES,
	.feeds_to_clear = ANSWER_YES,
	.rises_first = ANSWER_YES,
	.g87 = G87_BACK_BY_IJK,
	.pecks_fall = ANSWER_NO,
	.shift_by_ij = ANSWER_NO,
	.exact_path = ANSWER_YES,
	.repeat_letter = 'L',
};

/* LinuxCNC keeps the length. */
static void after_machine_move(struct interp *interp, int code, const bool moved[SLOT_COUNT])
{
	(void)interp;
	(void)code;
	(void)moved;
}

static bool read_block(struct interp *interp)
{
	static const struct block_rules rules = {.lexer = &linuxcnc_lexer_rules};

	return block_read(&interp->block, &interp->at, interp->config, &rules, interp, &interp->cautions);
}

const struct dialect dialect_linuxcnc = {
	.name = "linuxcnc",
	.manual = "LinuxCNC's manual",
	.g_codes = {&standard_g_codes, &(const struct code_set)CODE_SET(g_codes), &remapped_set, &mach3_set},
	.m_codes = {&basic_m_codes, &standard_m_codes, &(const struct code_set)CODE_SET(m_codes)},
	.words = {&(const struct word_set){words, sizeof(words) / sizeof(*words)}},
	.traits = {
		.last_of_group = ANSWER_NO,
		/* "G-code defaults"; the unit is that of the axes: INIT_CANON of the 2.9 emccanon.cc. */
		.power_on = {.units = G21, .units_of_control = true, .distance = G90, .plane = G17, .feed_mode = G94,
			     .path = G64},
		.whole_numbers = WHOLE_NUMBERS_UNITS,
		/* "Order of Execution". */
		.known_order = ANSWER_YES,
		/* The 2.9 interpreter, interp_check.cc. */
		.words_are_shared = ANSWER_YES,
		.dwell_letters = "P",
		.dwell_p = DWELL_P_SECONDS,
		.dwell_alone = ANSWER_NO,
		.text_before_percent = ANSWER_NO,
		.feed_forgotten = FEED_FORGOTTEN_BY_CODE,
		.empty_feed_move = EMPTY_FEED_MOVE_CHECKED,
		.g64_has_tolerance = ANSWER_YES,
		.arc_centre = ARC_CENTRE_INCREMENTAL,
		.arc_without_centre = ARC_WITHOUT_CENTRE_REFUSED,
		.arcs_have_turns = ANSWER_YES,
		.wrap_below_turn = ANSWER_YES,
		.cycles = &cycles,
		/* "Modal Groups": cycles and G80 are in one group with G0 to G3. */
		.cycles_apart = ANSWER_NO,
		.motion_beside_words = ANSWER_NO,
		.g53_rate = G53_RATE_PROGRAMMED,
		/* The interpreter has no machine axes: with switched kinematics G53 is a position of the tool point. */
		.g53_under_tcp = G53_UNDER_TCP_TOOL_POINT,
		.g53_asks_g91 = ANSWER_NO,
		.g53_alone = ANSWER_NO,
		.g28_without_axes = G28_WITHOUT_AXES_ALL,
		.references_in_parameters = ANSWER_YES,
		.g30_has_number = ANSWER_NO,
		.m19_has_time = ANSWER_YES,
		.t_word = T_WORD_SELECTS,
		/* "Order of Execution": T before M6. */
		.m6_loads_own_t = ANSWER_YES,
		.tool_change_stays = ANSWER_YES,
		.g54_has_number = ANSWER_NO,
		.g10_first = 0,
		.g10_last = SYSTEM_COUNT,
		.g10_l20 = G10_L20_HERE,
		.g10_incremental = G10_INCREMENTAL_WRITES,
		.g10_writes_tools = ANSWER_YES,
		.g10_writes_registers = ANSWER_NO,
		.one_shift = ANSWER_YES,
		.shifts_ignore_g91 = ANSWER_YES,
		.h_missing = H_MISSING_SPINDLE,
		.h_zero = H_ZERO_SPINDLE,
		.length_never_moves = ANSWER_YES,
		.d_word = D_WORD_TOOL,
		.g49_finds_length_gone = ANSWER_NO,
	},
	.after_machine_move = after_machine_move,
	.state_new = linuxcnc_state_new,
	.state_free = linuxcnc_state_free,
	.statement = control_flow_line,
	.read_block = read_block,
	.before_block = system_params_assign,
	.after_block = control_flow_after_block,
	.end_of_file = control_flow_end_of_file,
	.caller = control_flow_caller,
};
