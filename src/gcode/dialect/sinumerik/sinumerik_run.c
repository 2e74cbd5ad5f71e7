#include "gcode/dialect/sinumerik/sinumerik_run.h"

#include "base/units.h"
#include "gcode/dialect/sinumerik/block/sinumerik_tool.h"
#include "gcode/dialect/sinumerik/cycles/sinumerik_contour.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_call.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/dialect/sinumerik/path/sinumerik_comp.h"
#include "gcode/dialect/sinumerik/path/sinumerik_move.h"
#include "gcode/dialect/sinumerik/path/sinumerik_orientation.h"
#include "gcode/dialect/sinumerik/path/sinumerik_own_block.h"
#include "gcode/dialect/sinumerik/path/sinumerik_path.h"
#include "gcode/dialect/sinumerik/path/sinumerik_soft.h"
#include "gcode/dialect/sinumerik/path/sinumerik_target.h"
#include "gcode/dialect/sinumerik/path/sinumerik_tool_frame.h"
#include "gcode/dialect/sinumerik/sinumerik_invoke.h"
#include "gcode/execute/corner_insert.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/rotated_frame.h"
#include "gcode/execute/tool_length.h"
#include "gcode/execute/work_offset_use.h"

/* ---------------------------------------------------------- feed and spindle */

static bool set_feed(struct interp *interp, const struct sinumerik_block *block)
{
	struct state *state = &interp->state;
	const int given = block->code[SINUMERIK_FEED];
	/* "Constant cutting rate": from G97 on feeds are like those of G95, from G971 on like those of G94. */
	const int code = given == SINUMERIK_G(97) ? G95 : given == SINUMERIK_G(971) ? G94 : given;
	const double feed = block->value['F' - 'A'];

	if (code != CODE_NONE && state_feed_mode(code) != state->feed_mode) {
		state->feed_mode = state_feed_mode(code);
		state->feed_linear = state->feed_angular = 0;
	}
	if (code != CODE_NONE)
		state->unknown_modes &= ~(1U << G_FEED_MODE);
	if (!sinumerik_block_has(block, 'F') || block->code[SINUMERIK_ONCE] == G4)
		return true;
	if (feed < 0)
		return fault(&interp->at, block->column['F' - 'A'], "a feed rate cannot be negative");
	if (state->feed_mode != FEED_INVERSE_TIME) {
		state->feed_linear = feed * sinumerik_of(interp)->feed_scale;
		state->feed_angular = feed;
	}
	return true;
}

static bool set_speed(struct interp *interp, const struct sinumerik_block *block)
{
	const double speed = block->value['S' - 'A'];

	if (!sinumerik_block_has(block, 'S') || block->code[SINUMERIK_ONCE] == G4 ||
	    sinumerik_is_limit(block->code[SINUMERIK_ONCE]))
		return true;
	if (speed < 0)
		return fault(&interp->at, block->column['S' - 'A'], "a spindle speed cannot be negative");
	interp->state.speed = speed;
	interp->state.speed_is_zero = !(speed > 0);
	return true;
}

static bool turn_spindle(struct interp *interp, enum spindle_turn turn)
{
	if (turn == SPINDLE_STOPPED && !motion_commands_spindle_stops(interp))
		return false;
	interp->state.spindle = turn;
	return true;
}

/* --------------------------------------------------------------- M functions */

struct m_effects {
	int spindle_column;	/* of M3, M4 or M5; 0: none */
	bool stops;	/* M0, M1 */
	bool ends;	/* M2, M30, M17 */
	int column;	/* of that function */
	bool returns_only;	/* M17 */
};

static bool machine_m(struct interp *interp, enum mcode_action action, int column)
{
	const enum tcp_source tcp = interp->state.tcp;

	switch (action) {
	case MCODE_IGNORE:
		return true;
	case MCODE_SPINDLE_ON:
		return turn_spindle(interp, SPINDLE_CLOCKWISE);
	case MCODE_SPINDLE_OFF:
		return turn_spindle(interp, SPINDLE_STOPPED);
	default:
		break;
	}
	if (tcp == TCP_BY_PLANE)
		return fault(&interp->at, column,
			     "tool centre point control while CYCLE800 has swivelled; CYCLE800() first");
	if ((action == MCODE_TCP_ON) == (tcp != TCP_OFF))
		return true;
	sinumerik_frame_place(interp);
	return tool_length_switch_tcp(interp, column, action == MCODE_TCP_ON ? TCP_BY_LENGTH : TCP_OFF) &&
	       sinumerik_frame_changed(interp, column);
}

static bool known_m(struct interp *interp, int number, int column, struct m_effects *effects)
{
	const struct code *code = code_find(interp->config->dialect->m_codes, number);

	if (!code)
		return fault(&interp->at, column,
			     "M%d is not known; if it moves no axis, set <mcode number=\"%d\" action=\"ignore\"/> "
			     "in the machine file's <controller>",
			     number, number);
	if (code->state == CODE_REFUSED)
		return fault(&interp->at, column, "M%d: %s is not supported", number, code->what);
	if (code->group == M_SPINDLE && effects->spindle_column)
		return fault(&interp->at, column,
			     "M%d: the block turns or stops the spindle already at column %d; which comes last is not "
			     "known here",
			     number, effects->spindle_column);
	if (code->group == M_SPINDLE) {
		effects->spindle_column = column;
		return turn_spindle(interp, number == 3	  ? SPINDLE_CLOCKWISE
					    : number == 4 ? SPINDLE_COUNTERCLOCKWISE
							  : SPINDLE_STOPPED);
	}
	if (code->group != M_STOP)
		return true;
	effects->column = column;
	effects->stops = number <= 1;
	effects->ends = number > 1;
	effects->returns_only = number == 17;
	return true;
}

static bool run_m(struct interp *interp, const struct sinumerik_block *block, struct m_effects *effects)
{
	const struct controller *controller = &interp->config->controller;

	for (int i = 0; i < block->m_count; i++) {
		size_t k = 0;

		while (k < controller->mcode_count && controller->mcodes[k].number != block->m[i])
			k++;
		if (k < controller->mcode_count
			? !machine_m(interp, controller->mcodes[k].action, block->m_column[i])
			: !known_m(interp, block->m[i], block->m_column[i], effects))
			return false;
	}
	return !block->spindle_stands || turn_spindle(interp, SPINDLE_STOPPED);
}

/* -------------------------------------------------------------------- modes */

static void set_units(struct interp *interp, int code)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const double basic = interp->config->controller.unit;
	const bool inch = code == SINUMERIK_G(70) || code == SINUMERIK_G(700);

	sinumerik_frame_place(interp);
	interp->state.unknown_modes &= ~(1U << G_UNITS);
	interp->state.scale = inch ? MM_PER_INCH : 1;
	/* G70 and G71 concern only lengths: feeds stay in the basic unit of the control. */
	if (code == SINUMERIK_G(700) || code == SINUMERIK_G(710))
		sinumerik->feed_scale = interp->state.scale;
	else
		sinumerik->feed_scale = basic > 0 ? basic : 1;
}

static bool set_modes(struct interp *interp, const struct sinumerik_block *block)
{
	struct state *state = &interp->state;
	const int *code = block->code;

	if (code[SINUMERIK_PLANE] != CODE_NONE) {
		state->plane = code[SINUMERIK_PLANE];
		state->unknown_modes &= ~(1U << G_PLANE);
	}
	if (code[SINUMERIK_UNITS] != CODE_NONE)
		set_units(interp, code[SINUMERIK_UNITS]);
	if (code[SINUMERIK_DISTANCE] != CODE_NONE) {
		state->incremental = code[SINUMERIK_DISTANCE] == G91;
		state->unknown_modes &= ~(1U << G_DISTANCE);
	}
	sinumerik_path_set(interp, block);
	return sinumerik_comp_select(interp, block) && sinumerik_soft_select(interp, block);
}

/* G500, G54 to G57, G505 to G599. */
static bool select_system(struct interp *interp, const struct sinumerik_block *block)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const int code = block->code[SINUMERIK_SYSTEM] / 10, column = block->code_column[SINUMERIK_SYSTEM];
	int system;

	if (block->code[SINUMERIK_SYSTEM] == CODE_NONE)
		return true;
	system = code == 500 ? SYSTEM_NONE : code >= 505 ? SYSTEM_SETTABLE + code - 505 : code - 54;
	if (sinumerik->frames.swivelled && system == interp->state.system && sinumerik->frames.work_selected &&
	    !interp->state.work_assigned)
		return true;
	/*
	 * Posts select an offset and then swivel anew: only a move in between would need to know what happens to the
	 * plane.
	 */
	sinumerik->frames.plane_unsure = sinumerik->frames.swivelled;
	if (system != SYSTEM_NONE && !work_offset_use_require(interp, system, column))
		return false;
	sinumerik_frame_place(interp);
	interp->state.system = system;
	interp->state.work_assigned = false;
	sinumerik->frames.work_selected = true;
	sinumerik->frames.unsure = false;
	return sinumerik_frame_changed(interp, column);
}

/* --------------------------------------------------------------------- block */

static bool check_swivelled(struct interp *interp, const struct sinumerik_block *block)
{
	for (int slot = SLOT_A; slot <= SLOT_C && interp->state.tcp == TCP_BY_PLANE; slot++) {
		if (sinumerik_block_has(block, AXIS_LETTERS[slot]) && block->code[SINUMERIK_FRAME] == CODE_NONE &&
		    block->code[SINUMERIK_SUPPRESSION] == CODE_NONE)
			return fault(
			    &interp->at, block->column[AXIS_LETTERS[slot] - 'A'],
			    "%c while CYCLE800 has swivelled: the tool would leave the direction of its plane; "
			    "CYCLE800() first",
			    AXIS_LETTERS[slot]);
	}
	return true;
}

static bool check_words(struct interp *interp, const struct sinumerik_block *block)
{
	const bool reference = block->code[SINUMERIK_ONCE] == SINUMERIK_G(74) ||
			       block->code[SINUMERIK_ONCE] == SINUMERIK_G(75);

	if (block->machine_axes && !reference)
		return fault(&interp->at, sinumerik_block_axis_column(block),
			     "names of the machine's axes (X1=) are supported with G74 and G75 only");
	if (sinumerik_block_has_address(block, SINUMERIK_FP) && !reference)
		return fault(&interp->at, block->address_column[SINUMERIK_FP], "FP belongs to G75");
	if (sinumerik_block_has_address(block, SINUMERIK_RPL) && block->code[SINUMERIK_FRAME] == CODE_NONE)
		return fault(&interp->at, block->address_column[SINUMERIK_RPL], "RPL belongs to ROT and AROT");
	if (sinumerik_block_has(block, 'P') && !block->call[0])
		return fault(&interp->at, block->column['P' - 'A'], "P belongs to the call of a subprogram");
	if (block->call[0] && (block->letters & AXIS_BITS))
		return fault(&interp->at, block->call_column, "a call stands in a block without axis words");
	if (block->modal && ((block->letters & AXIS_BITS) || sinumerik_block_has(block, 'P')))
		return fault(&interp->at, block->modal_column, "MCALL stands in a block without axis words");
	return sinumerik_own_block_check(interp, block) && check_swivelled(interp, block);
}

/*
 * M30 in a subprogram returns to its caller, like M17 (from memory of the manual, "End of program"). A control that
 * ended the program there would move less than is checked.
 */
static bool finish(struct interp *interp, const struct m_effects *effects)
{
	if ((effects->stops || (effects->ends && !sinumerik_call_is_inside(interp))) &&
	    !sinumerik_comp_stop(interp, effects->column, effects->ends))
		return false;
	if ((effects->stops || effects->ends) && !effects->returns_only && !motion_commands_spindle_stops(interp))
		return false;
	if (!effects->ends)
		return true;
	if (!sinumerik_call_check_end(interp, effects->column))
		return false;
	if (sinumerik_call_is_inside(interp))
		return sinumerik_call_return(interp, effects->column);
	if (!effects->returns_only || motion_commands_spindle_stops(interp))
		interp->ended = true;
	return interp->ended;
}

/* Anything besides a move. It cannot follow a chamfer or rounding that waits for the next move. */
static bool has_more(const struct sinumerik_block *block)
{
	bool more = block->m_count > 0 || block->call[0] || block->modal || sinumerik_block_has(block, 'S') ||
		    sinumerik_block_has(block, 'T') || sinumerik_block_has(block, 'D');

	for (int group = 0; group < SINUMERIK_GROUPS; group++)
		more = more ||
		       (group != SINUMERIK_MOTION && group != SINUMERIK_DISTANCE && block->code[group] != CODE_NONE);
	return more;
}

/*
 * After an error, blocks are only read, to report other errors. The end of the block is taken as the position, so
 * that the next circle has its start.
 */
static void take_end(struct interp *interp, const struct sinumerik_block *block)
{
	slot_values place = *sinumerik_frame_place(interp), position;

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		const int index = AXIS_LETTERS[slot] - 'A';

		if (sinumerik_block_has(block, AXIS_LETTERS[slot]) && block->way[index] <= SINUMERIK_WAY_AC)
			place.v[slot] = block->value[index] * (slot_is_rotary(slot) ? 1 : interp->state.scale);
	}
	position = sinumerik_frame_straight(interp, &place);
	position = rotated_frame_position(&interp->state, &position);
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		state_set_position(&interp->state, slot, position.v[slot]);
	sinumerik_frame_moved(interp);
}

static bool run(struct interp *interp, struct lexer *lexer, const struct sinumerik_block *block)
{
	struct m_effects effects = {.stops = false};
	bool done, moved = false;

	interp->block.letters = 0;
	interp->block.motion = CODE_NONE;
	interp->block.corner = '\0';
	if (interp->corner.on && has_more(block))
		return corner_insert_end_block(interp);
	if (sinumerik_soft_waits(interp) && has_more(block))
		return sinumerik_soft_end_block(interp);
	sinumerik_soft_note(interp, block);
	if (!check_words(interp, block) || !sinumerik_contour_check(interp, block) ||
	    !sinumerik_comp_check(interp, block) || !set_feed(interp, block) ||
	    !set_speed(interp, block) || !sinumerik_tool_run(interp, block) || !run_m(interp, block, &effects) ||
	    !set_modes(interp, block) || !sinumerik_orientation_select(interp, block) ||
	    !select_system(interp, block) || !sinumerik_tool_frame_select(interp, block) ||
	    !sinumerik_own_block_run(interp, block, &done))
		return false;
	/* The code is active from the next motion on. */
	if (done && block->code[SINUMERIK_MOTION] != CODE_NONE)
		interp->state.motion = block->code[SINUMERIK_MOTION];
	if (!done && !sinumerik_move_run(interp, block, &moved))
		return false;
	if (!sinumerik_invoke_call(interp, lexer, block))
		return false;
	/* CT cannot continue a cycle or a subprogram. */
	if (block->call[0] || (moved && sinumerik_modal_acts(sinumerik_of(interp))))
		sinumerik_of(interp)->tangent.known = false;
	if (moved ? !sinumerik_invoke_modal(interp) : !done && !sinumerik_invoke_check(interp, block))
		return false;
	return finish(interp, &effects);
}

bool sinumerik_run(struct interp *interp, struct lexer *lexer, const struct sinumerik_block *block)
{
	if (run(interp, lexer, block))
		return true;
	if (interp->config->read.all_faults && !interp->state.incremental &&
	    block->code[SINUMERIK_SUPPRESSION] == CODE_NONE && block->code[SINUMERIK_ONCE] == CODE_NONE &&
	    block->code[SINUMERIK_FRAME] == CODE_NONE)
		take_end(interp, block);
	return false;
}
