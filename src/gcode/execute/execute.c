#include "gcode/execute/execute.h"

#include "base/apart.h"
#include "base/same_double.h"
#include "gcode/execute/arc_move.h"
#include "gcode/execute/bolt_pattern.h"
#include "gcode/execute/canned_cycle.h"
#include "gcode/execute/circular_pocket.h"
#include "gcode/execute/coordinate_rotation.h"
#include "gcode/execute/corner_insert.h"
#include "gcode/execute/cutter_comp/comp_codes.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"
#include "gcode/execute/cylinder.h"
#include "gcode/execute/dynamic_work_offset.h"
#include "gcode/execute/feedback_moves.h"
#include "gcode/execute/length_change.h"
#include "gcode/execute/mirror_image.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/nurbs_move.h"
#include "gcode/execute/offsets.h"
#include "gcode/execute/path_control.h"
#include "gcode/execute/pocket_milling.h"
#include "gcode/execute/polar_coordinates.h"
#include "gcode/execute/polar_interpolation.h"
#include "gcode/execute/probed_axes.h"
#include "gcode/execute/reference_return.h"
#include "gcode/execute/scaling.h"
#include "gcode/execute/space_arc.h"
#include "gcode/execute/spline_move.h"
#include "gcode/execute/straight_move.h"
#include "gcode/execute/tool_change.h"
#include "gcode/execute/tool_length.h"
#include "gcode/execute/tool_vector.h"
#include "gcode/execute/work_offset_use.h"

/* A mode that some words of a block need. */
struct mode_question {
	int group;
	bool needed;
	int column;
	const char *question;
	const char *answer;	/* the attribute of the machine file for it; or NULL */
};

#define UNITS_ANSWER "power_on_units=\"mm\" or \"inch\""

static bool refuse_mode(const struct interp *interp, const struct mode_question *mode)
{
	if (!mode->answer)
		return is_answered(interp, mode->column, false, mode->question);
	return fault(&interp->at, mode->column,
		     "a parameter of the control decides %s: set %s in the machine file's <controller>", mode->question,
		     mode->answer);
}

/* If words depend on a mode, the mode must be known: from the program, or as the mode at power-on. */
static APART bool check_modes(struct interp *interp)
{
	const struct block *block = &interp->block;
	unsigned *unknown = &interp->state.unknown_modes;
	bool dwells = block->g[G_NONMODAL] == G4 && block->motion == CODE_NONE;
	bool arc = block->motion == G2 || block->motion == G3;
	bool in_plane = arc || (block->motion != CODE_NONE && code_is_cycle(block->motion)) ||
			block->g[G_ROTATION] != CODE_NONE || block->g[G_CUTTER] != CODE_NONE;
	bool axes = !dwells && (block->letters & AXIS_BITS), feed = block_has(block, 'F');
	int column = block_motion_column(block), feed_column = feed ? block_column(block, 'F') : 0;
	const struct mode_question modes[] = {
	    {G_UNITS, axes || arc, column, "whether lengths are mm or inches before any G20 or G21", UNITS_ANSWER},
	    {G_UNITS, feed, feed_column, "whether F is in mm or inches before any G20 or G21", UNITS_ANSWER},
	    {G_DISTANCE, axes, column, "whether coordinates are absolute before any G90 or G91",
	     "power_on_distance=\"absolute\" or \"incremental\""},
	    {G_PLANE, in_plane, column, "which plane is active before any G17, G18 or G19",
	     "power_on_plane=\"xy\", \"zx\" or \"yz\""},
	    {G_ARC_DISTANCE, arc && (block->letters & (letter_bit('I') | letter_bit('J') | letter_bit('K'))), column,
	     "whether I, J and K are relative to the start of an arc", NULL},
	    {G_FEED_MODE, feed, feed_column, "what F means before any G93, G94 or G95", NULL},
	};

	for (int group = 0; group < G_GROUPS; group++)
		*unknown &= ~(block->g[group] == CODE_NONE ? 0U : 1U << group);
	for (size_t i = 0; i < sizeof(modes) / sizeof(modes[0]); i++) {
		if (modes[i].needed && (*unknown & 1U << modes[i].group))
			return refuse_mode(interp, &modes[i]);
	}
	return true;
}

/* G93, G94, G95; then F, which in inverse time mode is valid for its block only. */
static bool execute_feed(struct interp *interp)
{
	const struct block *block = &interp->block;
	struct state *state = &interp->state;
	enum feed_mode before = state->feed_mode;
	double feed;

	if (block->g[G_FEED_MODE] != CODE_NONE) {
		state->feed_mode = state_feed_mode(block->g[G_FEED_MODE]);
		if (state->feed_linear > 0 &&
		    !is_answered(interp, block->g_column[G_FEED_MODE], traits_of(interp)->feed_forgotten,
				 "whether the feed rate remains valid after G93, G94 or G95"))
			return false;
		if (traits_of(interp)->feed_forgotten == FEED_FORGOTTEN_BY_CODE || state->feed_mode != before)
			state->feed_linear = state->feed_angular = 0;
	}
	if (!block_has(block, 'F'))
		return true;
	feed = block_value(block, 'F');
	if (feed < 0)
		return fault(&interp->at, block_column(block, 'F'), "a feed rate must not be negative");
	if (state->feed_mode != FEED_INVERSE_TIME) {
		state->feed_linear = feed * state->scale;
		state->feed_angular = feed;
	}
	return true;
}

static bool execute_speed(struct interp *interp)
{
	const struct block *block = &interp->block;

	if (!block_has(block, 'S'))
		return true;
	if (block_value(block, 'S') < 0)
		return fault(&interp->at, block_column(block, 'S'), "a spindle speed must not be negative");
	interp->state.speed = block_value(block, 'S');
	interp->state.speed_is_zero = !(interp->state.speed > 0);
	return true;
}

/* Warns if no S was given: the control's former speed may be 0, and then a cutter without rotation enters the part. */
static void miss_speed(struct interp *interp, int code)
{
	struct state *state = &interp->state;

	if (state->speed > 0 || state->speed_is_zero || state->speed_missed)
		return;
	state->speed_missed = true;
	caution(&interp->at, interp->block.m_column[M_SPINDLE],
		"M%d without a spindle speed (S): the spindle is assumed to turn, but the control may have kept a "
		"speed of 0",
		code);
}

/* Canned cycles may depend on the direction of the spindle, and cutting on whether the spindle turns. */
static bool execute_spindle(struct interp *interp)
{
	int code = interp->block.m[M_SPINDLE];

	if (code != CODE_NONE && code != 3 && code != 4 && !motion_commands_spindle_stops(interp))
		return false;
	if (code != CODE_NONE)
		interp->state.spindle = code == 3   ? SPINDLE_CLOCKWISE
					: code == 4 ? SPINDLE_COUNTERCLOCKWISE
						    : SPINDLE_STOPPED;
	if (interp->state.spindle != SPINDLE_STOPPED && code != CODE_NONE)
		miss_speed(interp, code);
	return true;
}

/* M0, M1, M2, M30: the spindle stands during the stop. M3 is active again after M0 and M1. */
static bool execute_stop(struct interp *interp)
{
	int code = interp->block.m[M_STOP];

	if (code == CODE_NONE)
		return true;
	return cutter_comp_stop(interp) && (code >= 97 || motion_commands_spindle_stops(interp));
}

/* G61 and G61.1 follow the path exactly; G64 may leave it, at most by P if P is given (LinuxCNC's manual, "G64"). */
static bool execute_path(struct interp *interp)
{
	const struct block *block = &interp->block;
	struct state *state = &interp->state;
	/* G61.1 is exact on LinuxCNC; on controls whose G64 has no P, a parameter gives the tolerance of G61.1. */
	bool blends = block->g[G_PATH] == G62 || block->g[G_PATH] == G63 || block->g[G_PATH] == G64 ||
		      (block->g[G_PATH] == G61_1 && traits_of(interp)->g64_has_tolerance == ANSWER_NO);

	if (block->g[G_PATH] == CODE_NONE)
		return true;
	if (block->g[G_PATH] == G61_1 &&
	    !is_answered(interp, block->g_column[G_PATH], traits_of(interp)->g64_has_tolerance,
			 "whether G61.1 keeps to the programmed path"))
		return false;
	if (state->contour && blends) {
		state->blend_before = true;
		return true;
	}
	if (state->contour)
		return fault(&interp->at, block->g_column[G_PATH],
			     "G%g while G5.1, G8 or G5 P10000 is active is not supported", block->g[G_PATH] / 10.0);
	state->blend = blends;
	state->blend_tolerance = 0;
	if (!state->blend || !block_has(block, 'P') || traits_of(interp)->g64_has_tolerance == ANSWER_NO)
		return true;
	if (!is_answered(interp, block_column(block, 'P'), traits_of(interp)->g64_has_tolerance,
			 "whether P of G64 is a path tolerance"))
		return false;
	if (block_value(block, 'P') < 0)
		return fault(&interp->at, block_column(block, 'P'), "a path tolerance must not be negative");
	state->blend_tolerance = block_value(block, 'P') * state->scale;
	return true;
}

/* Is the word an angle: R of G68 and G68.2; I, J and K of G68.2; J and K of G70 and G71? */
static bool is_angle(const struct block *block, char letter)
{
	int code = block->g[G_ROTATION], pattern = block->g[G_NONMODAL];

	if ((pattern == G70 || pattern == G71) && (letter == 'J' || letter == 'K'))
		return true;
	return ((code == G68 || code_tilts(code)) && letter == 'R') ||
	       (code_tilts(code) && letter >= 'I' && letter <= 'K');
}

/* Is the word a number: K of some canned cycles, Q and R of G5.1, R of M19, Q of G68.2 and M98? */
static bool is_count(const struct block *block, const struct dialect_traits *traits, char letter)
{
	if (block->g[G_SCALING] == G51 && letter >= 'I' && letter <= 'K')
		return true;
	if (block->g[G_CONTOUR] != CODE_NONE && (letter == 'Q' || letter == 'R'))
		return true;
	if ((block->m[M_SPINDLE] == 19 && letter == 'R') || (code_tilts(block->g[G_ROTATION]) && letter == 'Q') ||
	    (block->m[M_STOP] >= 97 && letter == 'Q'))
		return true;
	return letter == 'K' && traits->cycles && traits->cycles->repeat_letter == 'K' && block->motion != CODE_NONE &&
	       code_is_cycle(block->motion);
}

/*
 * Fanuc 30i-B operator's manual, decimal point programming; Haas, setting 162: a number without a decimal point counts
 * least input increments. In inches the figure of an increment is a tenth of that in mm (IS-B: 0.001 mm, 0.0001 inch,
 * 0.001 degrees).
 */
static APART bool take_increments(struct interp *interp, uint32_t left)
{
	struct block *block = &interp->block;
	enum whole_numbers whole = traits_of(interp)->whole_numbers;
	double increment = interp->config->controller.least_input;
	/* least_input 1: with parameter 3401#0 (DPI) or setting 162 whole numbers count whole mm, inches or degrees. */
	double linear = interp->state.scale > 1 && increment < 1 ? increment / 10 : increment;

	if (block->corner && !block->corner_point && whole == WHOLE_NUMBERS_INCREMENTS) {
		if (!(increment > 0))
			return dialect_refuse_whole_number(&interp->at, block->corner_column, block->corner,
							   block->corner_value);
		block->corner_value *= linear;
	}
	if (whole == WHOLE_NUMBERS_UNITS || block->g[G_NONMODAL] == G4)
		return true;
	for (const char *letter = AXIS_LETTERS "IJKQR"; left && *letter; letter++) {
		int slot = slot_of_letter(*letter);

		if (!(left & letter_bit(*letter)))
			continue;
		left &= ~letter_bit(*letter);
		if (is_count(block, traits_of(interp), *letter) || same_double(block_value(block, *letter), 0))
			continue;
		if (!is_answered(interp, block_column(block, *letter), whole,
				 "what a number without a decimal point means"))
			return false;
		if (!(increment > 0))
			return dialect_refuse_whole_number(&interp->at, block_column(block, *letter), *letter,
							   block_value(block, *letter));
		block->value[*letter - 'A'] *=
		    (slot >= 0 && slot_is_rotary(slot)) || is_angle(block, *letter) ||
				    polar_coordinates_is_angle(interp, *letter) ? increment : linear;
	}
	return true;
}

static bool execute_increments(struct interp *interp)
{
	const struct block *block = &interp->block;
	const uint32_t whole = block->letters & ~block->points & (AXIS_BITS | ARC_BITS | letter_bit('Q'));

	return (!whole && !block->corner) || take_increments(interp, whole);
}

static void execute_modes(struct interp *interp)
{
	const struct block *block = &interp->block;
	struct state *state = &interp->state;

	if (block->g[G_DISTANCE] != CODE_NONE)
		state->incremental = block->g[G_DISTANCE] == G91;
	if (block->g[G_ARC_DISTANCE] != CODE_NONE)
		state->arc_absolute = block->g[G_ARC_DISTANCE] == G90_1;
	if (block->g[G_RETRACT] != CODE_NONE)
		state->retract = block->g[G_RETRACT];
}

static bool execute_nonmodal(struct interp *interp)
{
	switch (interp->block.g[G_NONMODAL]) {
	case G10:
		return offsets_set(interp);
	case G12:
	case G13:
		return circular_pocket_mill(interp);
	case G28:
	case G30:
		return reference_return_go(interp);
	case G28_1:
	case G30_1:
		return reference_return_remember(interp);
	case G7_1:
		return cylinder_switch(interp);
	case G150:
		return pocket_milling_begin(interp);
	case G12_1:
	case G13_1:
		return polar_interpolation_switch(interp);
	case G70:
	case G71:
		return bolt_pattern_run(interp);
	case G53_1:
	case G53_6:
		return coordinate_rotation_orient_tool(interp);
	case G54_2:
	case G54_4:
		return work_offset_use_check_end(interp);
	case G52:
	case G92:
	case G92_1:
	case G92_2:
	case G92_3:
		return offsets_shift(interp);
	case CODE_NONE:
	case G4:	/* has been carried out before */
	case G53:	/* belongs to the motion */
	case G22:	/* moves nothing */
		return true;
	default:
		return fault(&interp->at, interp->block.g_column[G_NONMODAL],
			     "G%g is not supported; post the program without it", interp->block.g[G_NONMODAL] / 10.0);
	}
}

static bool cancel_motion(struct interp *interp)
{
	struct state *state = &interp->state;

	state->motion = state_motion_after_g80(state, traits_of(interp));
	return true;
}

/* Carries out the motion of the block. All these functions send moves by motion_commands.h; none calls another. */
static bool execute_motion(struct interp *interp)
{
	static const struct {
		int code;
		bool (*run)(struct interp *interp);
	} motions[] = {
	    {G0, straight_move_run},	 {G1, straight_move_run},     {G2, arc_move_run},
	    {G3, arc_move_run},		 {G80, cancel_motion},	      {G33, feedback_moves_run},
	    {G31, feedback_moves_run},	 {311, feedback_moves_run},   {312, feedback_moves_run},
	    {G31_3, feedback_moves_run}, {G5, spline_move_run},	      {G5_1, spline_move_run},
	    {G5_2, spline_move_run},	 {G5_3, spline_move_run},     {G6_2, nurbs_move_run},
	    {G33_1, feedback_moves_run}, {G38_2, feedback_moves_run}, {G38_3, feedback_moves_run},
	    {G38_4, feedback_moves_run}, {G38_5, feedback_moves_run}, {G2_4, space_arc_run},
	    {G3_4, space_arc_run},
	};
	struct state *state = &interp->state;
	int code = interp->block.motion, given = interp->block.g[G_MOTION];

	if ((interp->block.vectors && !tool_vector_check_block(interp)) ||
	    ((interp->spline.open || interp->spline.goes_on) && !spline_move_check_block(interp)) ||
	    (state->dynamic.unsure_code != CODE_NONE && !dynamic_work_offset_check_cut(interp)) ||
	    (state->length_moves && !length_change_go(interp)))
		return false;
	if (given >= G0 && given <= G3)
		state->motion = state->path_motion = given;
	if (code == CODE_NONE && given == CODE_NONE)
		return true;
	if (code != CODE_NONE && code_is_cycle(code))
		return canned_cycle_run(interp);
	state->cycle.has_level = false;
	/* Another code has used the words. */
	if (code == CODE_NONE)
		return true;
	for (size_t i = 0; i < sizeof(motions) / sizeof(motions[0]); i++) {
		if (motions[i].code == code)
			return motions[i].run(interp);
	}
	return fault(&interp->at, block_motion_column(&interp->block),
		     "G%g: this motion is not supported; write it as lines and circles (G1, G2, G3)", code / 10.0);
}

/* Active modes may refuse the block; modes that are valid for one block only end here. */
static bool start_block(struct interp *interp)
{
	struct state *state = &interp->state;

	if (state->unknown_modes && !check_modes(interp))
		return false;
	probed_axes_forget_turned(state);
	state->length_moves = false;
	/* In nearly every block none of these modes is active. */
	return (!interp->space_arc.on || space_arc_check_block(interp)) &&
	       (!state->cylinder.on || cylinder_check_block(interp)) &&
	       (!state->polar_interpolation.on || polar_interpolation_start_block(interp)) &&
	       pocket_milling_start_block(interp) &&
	       (!corner_insert_concerns(interp) || corner_insert_start_block(interp)) &&
	       ((!state->frame.on && state->plane_parts.form == 0) || coordinate_rotation_start_block(interp)) &&
	       dynamic_work_offset_start_block(interp) &&
	       (interp->comp.side == 0 || comp_codes_start_block(interp));
}

/* A block with no code but that of its motion: has the same effect as execute_codes. */
static bool execute_plain(struct interp *interp)
{
	return execute_feed(interp) && execute_increments(interp) && comp_codes_check_block(interp) &&
	       (!interp->state.work_assigned || work_offset_use_check(interp)) && execute_motion(interp);
}

/* LinuxCNC's manual, "Order of Execution"; NIST RS274/NGC, table 8. */
static bool execute_codes(struct interp *interp)
{
	const struct dialect *dialect = interp->config->dialect;
	const struct block *block = &interp->block;
	struct state *state = &interp->state;
	/* B-64484EN, "Auxiliary Function": the builder decides whether M-codes act with the move or after it. */
	bool changes_late = block->m[M_TOOL] == 6 && interp->config->controller.m6_with_move == M6_AFTER_MOVE;

	if (block->g[G_UNITS] != CODE_NONE && block->letters &&
	    !is_answered(interp, block->g_column[G_UNITS], dialect->traits.known_order,
			 "whether a unit applies to all words of its block"))
		return false;
	/* Fanuc and Haas: the unit is at the start of the program, and is valid for its whole block. */
	if (block->g[G_UNITS] != CODE_NONE && dialect->traits.known_order != ANSWER_YES)
		state->scale = state_unit(block->g[G_UNITS]);
	if (!execute_feed(interp) || !execute_speed(interp))
		return false;
	if (!tool_change_select(interp) || (!changes_late && !tool_change_run(interp)) || !tool_length_mcode(interp))
		return false;
	if (!execute_spindle(interp))
		return false;
	if (block->g[G_NONMODAL] == G4 && !motion_commands_dwell(interp))
		return false;
	if (block->g[G_PLANE] != CODE_NONE)
		state->plane = block->g[G_PLANE];
	if (block->g[G_UNITS] != CODE_NONE)
		state->scale = state_unit(block->g[G_UNITS]);
	if (!execute_increments(interp) || !comp_codes_select(interp) || !comp_codes_check_block(interp))
		return false;
	if (!tool_length_select(interp) || !offsets_select(interp) || !work_offset_use_check(interp) ||
	    !execute_path(interp) || !path_control_select(interp))
		return false;
	execute_modes(interp);
	if (!polar_coordinates_switch(interp) || !mirror_image_switch(interp) || !scaling_switch(interp) ||
	    !coordinate_rotation_turn(interp) ||
	    !dynamic_work_offset_switch(interp))
		return false;
	if (!execute_nonmodal(interp) || !execute_motion(interp) || (changes_late && !tool_change_run(interp)) ||
	    !execute_stop(interp))
		return false;
	if (block->m[M_STOP] >= 97 && !is_answered(interp, block->m_column[M_STOP], dialect->after_block != NULL,
						   "what the calls of subprograms (M97 to M99) do"))
		return false;
	interp->ended = block->m[M_STOP] == 2 || block->m[M_STOP] == 30;
	return true;
}

bool execute_block(struct interp *interp)
{
	const struct dialect *dialect = interp->config->dialect;

	if (!start_block(interp) || !(interp->block.plain ? execute_plain(interp) : execute_codes(interp)))
		return false;
	return !dialect->after_block || dialect->after_block(interp);
}
