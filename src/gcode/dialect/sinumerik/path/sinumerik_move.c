#include "gcode/dialect/sinumerik/path/sinumerik_move.h"

#include <math.h>

#include "base/same_double.h"
#include "base/units.h"
#include "gcode/dialect/sinumerik/cycles/sinumerik_contour.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_open_place.h"
#include "gcode/dialect/sinumerik/path/sinumerik_circle.h"
#include "gcode/dialect/sinumerik/path/sinumerik_comp.h"
#include "gcode/dialect/sinumerik/path/sinumerik_great_circle.h"
#include "gcode/dialect/sinumerik/path/sinumerik_orientation.h"
#include "gcode/dialect/sinumerik/path/sinumerik_polar.h"
#include "gcode/dialect/sinumerik/path/sinumerik_soft.h"
#include "gcode/dialect/sinumerik/path/sinumerik_target.h"
#include "gcode/execute/corner_insert.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/parallel_moves.h"
#include "gcode/execute/tool_length.h"

#define CIRCLE_BITS (1U << SINUMERIK_CR | 1U << SINUMERIK_AR | 1U << SINUMERIK_TURN | 1U << SINUMERIK_I1 | \
		     1U << SINUMERIK_J1 | 1U << SINUMERIK_K1)

/* Words that give coordinates of the plane. */
#define PLANE_BITS (SINUMERIK_POLAR_BITS | SINUMERIK_LINE_BIT)

/* ------------------------------------------------------------------- lines */

/* The data that functions shared with other dialects read of a block. */
static void show_block(struct interp *interp, const struct sinumerik_block *block, int motion)
{
	static const struct {
		enum sinumerik_address address;
		char letter;
	} corners[] = {{SINUMERIK_CHF, 'L'}, {SINUMERIK_CHR, 'C'}, {SINUMERIK_RND, 'R'}};
	struct block *shown = &interp->block;
	uint32_t left = block->letters & (letter_bit('F') | AXIS_BITS);

	shown->motion = motion;
	shown->g[G_MOTION] = motion;
	shown->g_column[G_MOTION] = block->code[SINUMERIK_MOTION] != CODE_NONE ? block->code_column[SINUMERIK_MOTION]
									       : sinumerik_block_axis_column(block);
	shown->letters = left;
	for (const char *letter = AXIS_LETTERS "F"; left; letter++) {
		if (!(left & letter_bit(*letter)))
			continue;
		left &= ~letter_bit(*letter);
		shown->value[*letter - 'A'] = block->value[*letter - 'A'];
		shown->column[*letter - 'A'] = block->column[*letter - 'A'];
	}
	for (size_t i = 0; i < sizeof(corners) / sizeof(corners[0]); i++) {
		/* RND=0 and the like mean no rounding. */
		if (!sinumerik_block_has_address(block, corners[i].address) ||
		    !(block->address_value[corners[i].address] > 0))
			continue;
		shown->corner = corners[i].letter;
		shown->corner_value = block->address_value[corners[i].address];
		shown->corner_column = block->address_column[corners[i].address];
	}
}

#define LINEAR_BITS (letter_bit('X') | letter_bit('Y') | letter_bit('Z'))

static bool go_straight(struct interp *interp, const slot_values *target, struct canon_move *move)
{
	return sinumerik_of(interp)->open.on
		   ? parallel_moves_go_from_open(interp, target, move, &sinumerik_of(interp)->open.box)
		   : motion_commands_go(interp, target, move);
}

/* `circle` is NULL for a straight move. */
static bool arrive(struct interp *interp, const slot_values *target, struct canon_move *move,
		   const struct sinumerik_circle *circle)
{
	const slot_values straight = sinumerik_frame_straight(interp, target), from = *sinumerik_frame_place(interp);
	bool good, waits = false;

	if (sinumerik_contour_is_read(interp))
		return sinumerik_contour_take(interp, target, circle);
	if (sinumerik_soft_waits(interp)) {
		if (!sinumerik_soft_pass(interp, target, move, circle, &waits))
			return false;
		if (waits)
			return true;
	}
	if (corner_insert_concerns(interp)) {
		const struct corner_move next = {.target = &straight, .move = move, .is_arc = circle != NULL,
						 .centre = circle ? circle->centre : (struct plane_point){0, 0}};

		if (circle && !circle->in_plane)
			return fault(&interp->at, interp->block.g_column[G_MOTION],
				     "CIP beside CHF, CHR or RND is not supported");
		if (!corner_insert_pass(interp, &next, &waits))
			return false;
	}
	if (waits)
		good = true;
	else if (!cutter_comp_is_on(interp)) {
		good = circle ? motion_commands_go(interp, &straight, move)
			      : go_straight(interp, &straight, move);
		sinumerik_open_place_settle(interp, interp->block.letters);
	} else if (!circle)
		good = cutter_comp_line(interp, &straight, move);
	else if (!circle->in_plane)
		good = fault(&interp->at, interp->block.g_column[G_MOTION],
			     "CIP under tool radius compensation is not supported");
	else
		good = cutter_comp_arc(interp, &straight, circle->centre, circle->turns, move);
	if (!good)
		return false;
	sinumerik_circle_keep_tangent(interp, &from, target, circle);
	sinumerik_of(interp)->place.program = *target;
	sinumerik_of(interp)->place.known = true;
	return true;
}

bool sinumerik_move_to(struct interp *interp, const slot_values *target, bool rapid)
{
	struct canon_move move = {.kind = rapid ? CANON_RAPID : CANON_FEED};

	if (!rapid) {
		interp->block.motion = interp->block.g[G_MOTION] = G1;
		if (!motion_commands_feed(interp, &move.feed))
			return false;
	}
	return arrive(interp, target, &move, NULL);
}

/*
 * 840D sl, "Suppression of frames": with SUPA, G53 and G153 the tool offsets stay active. While TRAORI is on, their
 * zero is not certain. A swivelled head rotates the tool length, so it needs D0. Over a swivelled table the tool is
 * parallel to Z, as before.
 */
static bool go_in_machine(struct interp *interp, const struct sinumerik_block *block, struct canon_move *move)
{
	const struct state *state = &interp->state;
	const int column = block->code_column[SINUMERIK_SUPPRESSION];
	const bool swivelled = state->tcp != TCP_OFF;
	struct suspended suspended;
	slot_values target;

	move->machine_coordinates = true;
	if (state->tcp == TCP_BY_LENGTH)
		return fault(&interp->at, column,
			     "positions of the machine's axes (SUPA, G53, G153) while TRAORI is on; TRAFOOF first");
	if (state->tcp == TCP_BY_PLANE && !same_double(state->length, 0) && !sinumerik_of(interp)->frames.tool_upright)
		return fault(
		    &interp->at, column,
		    "positions of the machine's axes (SUPA, G53, G153) with a tool's length while CYCLE800 has "
		    "swivelled; write D0 beside it");
	/* The axes of the machine are not parallel to those along which a swivelled tool is guided. */
	if (swivelled)
		sinumerik_open_place_turned(interp);
	if (!tool_length_suspend(interp, column, &suspended) ||
	    !sinumerik_target_find_machine(interp, block, &target) || !go_straight(interp, &target, move) ||
	    !tool_length_resume(interp, column, &suspended))
		return false;
	if (!swivelled || (block->letters & LINEAR_BITS) == LINEAR_BITS)
		sinumerik_open_place_settle_machine(interp, block->letters);
	sinumerik_frame_moved(interp);
	sinumerik_frame_place(interp);
	return true;
}

static bool run_line(struct interp *interp, const struct sinumerik_block *block, bool machine)
{
	const bool rapid = interp->state.motion == G0;
	struct canon_move move;
	struct sinumerik_turn turn = {.on_circle = false};
	slot_values target;

	canon_move_begin(&move, rapid ? CANON_RAPID : CANON_FEED);
	if (!rapid && !motion_commands_feed(interp, &move.feed))
		return false;
	if (machine)
		return go_in_machine(interp, block, &move);
	if (!sinumerik_target_find(interp, block, &target))
		return false;
	if (interp->state.tcp == TCP_BY_LENGTH && !sinumerik_orientation_find(interp, block, &target, &turn))
		return false;
	if (!sinumerik_comp_check_turn(interp, &target, turn.on_circle, sinumerik_block_axis_column(block)))
		return false;
	if (turn.on_circle) {
		const int column = sinumerik_block_axis_column(block);
		bool evenly;

		if (!sinumerik_great_circle_go(interp, column, &target, turn.by_direction ? &turn.direction : NULL,
					       &move, &evenly))
			return false;
		if (!evenly)
			return true;
		if (turn.by_direction && !sinumerik_orientation_turn_to(interp, column, turn.direction, &target))
			return false;
	}
	return arrive(interp, &target, &move, NULL);
}

/* ----------------------------------------------------------------- threads */

static bool is_thread(int motion)
{
	return motion == SINUMERIK_G(33) || motion == SINUMERIK_G(331) || motion == SINUMERIK_G(332);
}

/*
 * 840D sl, "Thread cutting (G33)" and "Rigid tapping (G331, G332)": a straight move along one axis, by the pitch (I,
 * J, K) in each revolution of the spindle.
 */
static bool run_thread(struct interp *interp, const struct sinumerik_block *block, bool machine)
{
	struct canon_move move = {.kind = CANON_FEED, .spindle_turns = true, .turn = TURN_OF_TAP};
	const int column = interp->block.g_column[G_MOTION], code = interp->state.motion / 10;
	slot_values target;
	double pitch = 0;

	if (machine || interp->comp.side != 0 || interp->corner.on || interp->state.tcp == TCP_BY_LENGTH)
		return fault(&interp->at, column,
			     "G%d beside SUPA, TRAORI, a chamfer or tool radius compensation is not supported", code);
	for (int i = 0; i < 3; i++) {
		if (sinumerik_block_has(block, "XYZ"[i]) && sinumerik_block_has(block, "IJK"[i]))
			pitch = fabs(block->value["IJK"[i] - 'A']) * interp->state.scale;
	}
	if (!(pitch > 0))
		return fault(&interp->at, column, "G%d needs the pitch of its axis: I of X, J of Y, K of Z", code);
	move.feed.linear =
	    motion_commands_thread_feed(interp, column, pitch * interp->state.speed / SECONDS_PER_MINUTE);
	return sinumerik_target_find(interp, block, &target) && arrive(interp, &target, &move, NULL);
}

/* "Tapping with compensating chuck (G63)": a straight move with the programmed feed, in this block only. */
bool sinumerik_move_tap(struct interp *interp, const struct sinumerik_block *block)
{
	struct canon_move move = {.kind = CANON_FEED, .spindle_turns = true, .turn = TURN_OF_TAP};
	const int column = block->code_column[SINUMERIK_ONCE];
	slot_values target;

	if (!(block->letters & AXIS_BITS))
		return fault(&interp->at, column, "G63 needs the axis that it moves");
	if (interp->comp.side != 0 || interp->corner.on || block->code[SINUMERIK_SUPPRESSION] != CODE_NONE)
		return fault(&interp->at, column,
			     "G63 beside SUPA, a chamfer or tool radius compensation is not supported");
	show_block(interp, block, G1);
	interp->block.g_column[G_MOTION] = column;
	return sinumerik_target_check(interp, block, false, false) && motion_commands_feed(interp, &move.feed) &&
	       sinumerik_target_find(interp, block, &target) && arrive(interp, &target, &move, NULL);
}

static bool run_circle(struct interp *interp, const struct sinumerik_block *block)
{
	struct canon_move move = {.kind = CANON_ARC};
	struct sinumerik_turn turn = {.on_circle = false};
	struct sinumerik_circle circle;
	slot_values target;

	if (!sinumerik_open_place_check(interp, interp->block.g_column[G_MOTION], "a circle") ||
	    !motion_commands_feed(interp, &move.feed) || !sinumerik_target_find(interp, block, &target))
		return false;
	if (interp->state.tcp == TCP_BY_LENGTH && !sinumerik_orientation_find(interp, block, &target, &turn))
		return false;
	if (turn.on_circle)
		return fault(&interp->at, interp->block.g_column[G_MOTION],
			     "a circle during which the tool turns on a great circle (ORIVECT) is not supported");
	if (!sinumerik_comp_check_turn(interp, &target, false, interp->block.g_column[G_MOTION]) ||
	    !sinumerik_circle_find(interp, block, &target, &circle))
		return false;
	if (circle.straight) {
		move.kind = CANON_FEED;
		interp->block.motion = interp->block.g[G_MOTION] = G1;
		return arrive(interp, &target, &move, NULL);
	}
	if (circle.in_plane)
		interp->block.motion = interp->block.g[G_MOTION] = circle.clockwise ? G2 : G3;
	move.arc = circle.arc;
	return arrive(interp, &target, &move, &circle);
}

/* 840D sl, "Chamfer, rounding (CHF, CHR, RND)": between two blocks of G1, G2 or G3 in the plane. */
static bool check_corner(struct interp *interp, const struct sinumerik_block *block, bool moves)
{
	static const enum sinumerik_address corners[] = {SINUMERIK_CHF, SINUMERIK_CHR, SINUMERIK_RND};
	int count = 0, column = 0;

	for (size_t i = 0; i < sizeof(corners) / sizeof(corners[0]); i++) {
		if (!sinumerik_block_has_address(block, corners[i]))
			continue;
		count++;
		column = block->address_column[corners[i]];
		if (block->address_value[corners[i]] < 0)
			return fault(&interp->at, column, "a chamfer or rounding cannot be negative");
	}
	if (count == 0)
		return true;
	if (count > 1)
		return fault(&interp->at, column, "a block can have only one of CHF, CHR and RND");
	if (!moves || interp->state.motion == G0)
		return fault(&interp->at, column, "CHF, CHR and RND need a block with G1, G2 or G3");
	return sinumerik_of(interp)->frames.even ||
	       fault(&interp->at, column, "a rounding or chamfer where the frame scales its axes differently");
}

static bool refuse_words(struct interp *interp, const struct sinumerik_block *block, bool circle)
{
	if ((block->addresses & CIRCLE_BITS) && !circle) {
		for (int i = 0; i < SINUMERIK_ADDRESSES; i++) {
			if (block->addresses & CIRCLE_BITS & 1U << i)
				return fault(&interp->at, block->address_column[i],
					     "this word belongs to a circle (G2, G3, CIP)");
		}
	}
	if ((block->addresses & SINUMERIK_LINE_BIT) &&
	    ((interp->state.motion != G0 && interp->state.motion != G1) ||
	     block->code[SINUMERIK_SUPPRESSION] != CODE_NONE))
		return fault(&interp->at, block->address_column[SINUMERIK_ANG],
			     "ANG= belongs to a straight line (G0, G1) in the program's coordinates");
	for (const char *letter = "IJK"; *letter && !circle && !is_thread(interp->state.motion); letter++) {
		if (sinumerik_block_has(block, *letter))
			return fault(&interp->at, block->column[*letter - 'A'], "%c belongs to a circle (G2, G3)",
				     *letter);
	}
	if ((block->addresses & SINUMERIK_ANGLE_BITS) && interp->state.tcp != TCP_BY_LENGTH)
		return fault(&interp->at, sinumerik_block_axis_column(block),
			     "A2=, B2= and C2= need TRAORI, which turns the tool by these angles");
	if ((block->addresses & SINUMERIK_VECTOR_BITS) && interp->state.tcp != TCP_BY_LENGTH)
		return fault(&interp->at, sinumerik_block_axis_column(block),
			     "A3=, B3= and C3= need TRAORI, which turns the tool into their direction");
	return true;
}

/*
 * 840D sl, "Traverse positioning axes (POS)": the block ends when all its axes have arrived. Each of them moves by
 * itself, so the common path is not known: they may be anywhere between start and end. So may axes that G0 moves
 * beside them; other motions are paths that the POS axes would have to follow. With frames that rotate, one axis of
 * the program is several axes of the machine.
 */
static bool run_position(struct interp *interp, const struct sinumerik_block *block)
{
	struct canon_move move = {.kind = CANON_RAPID};
	const int column = block->positions_column;
	const uint32_t axes = block->letters & AXIS_BITS;
	slot_values target;

	if ((axes != block->positions && interp->state.motion != G0) ||
	    (block->addresses & (SINUMERIK_DIRECTION_BITS | PLANE_BITS)) || (block->letters & SINUMERIK_CENTRE_BITS))
		return fault(&interp->at, column,
			     "POS beside other axes that do not move with G0: which way they all go is not known; "
			     "write POS in a block of its own");
	move.apart = (axes & (axes - 1)) != 0;
	if (interp->state.tcp != TCP_OFF || interp->state.frame.on || interp->comp.side != 0 || interp->corner.on ||
	    block->code[SINUMERIK_SUPPRESSION] != CODE_NONE || sinumerik_modal_acts(sinumerik_of(interp)))
		return fault(&interp->at, column,
			     "POS with TRAORI, CYCLE800, ROT, SCALE, MIRROR, tool radius compensation, a chamfer, SUPA "
			     "or MCALL is not supported");
	show_block(interp, block, G0);
	return sinumerik_target_check(interp, block, false, false) && sinumerik_target_find(interp, block, &target) &&
	       arrive(interp, &target, &move, NULL);
}

static int shown_motion(int motion)
{
	if (motion == SINUMERIK_CIP || motion == SINUMERIK_CT)
		return G2;
	return is_thread(motion) ? G1 : motion;
}

bool sinumerik_move_run(struct interp *interp, const struct sinumerik_block *block, bool *moved)
{
	const int given = block->code[SINUMERIK_MOTION];
	const bool machine = block->code[SINUMERIK_SUPPRESSION] != CODE_NONE;
	struct state *state = &interp->state;
	bool circle, axes;

	if (given != CODE_NONE)
		state->motion = given;
	*moved = false;
	if (block->code[SINUMERIK_SOFT] != CODE_NONE)
		return sinumerik_soft_run(interp, block);
	if (block->positions)
		return run_position(interp, block);
	circle = state->motion == G2 || state->motion == G3 || state->motion == SINUMERIK_CIP ||
		 state->motion == SINUMERIK_CT;
	axes = (block->letters & AXIS_BITS) ||
	       (block->addresses & (SINUMERIK_DIRECTION_BITS | PLANE_BITS)) ||
	       (circle && ((block->letters & SINUMERIK_CENTRE_BITS) || (block->addresses & CIRCLE_BITS)));
	if (!refuse_words(interp, block, circle) || (block->addresses && !check_corner(interp, block, axes)))
		return false;
	if (!axes)
		return true;
	if (!sinumerik_target_check(interp, block, machine, circle || (block->addresses & PLANE_BITS)))
		return false;
	*moved = !machine;
	show_block(interp, block, shown_motion(state->motion));
	if (machine && sinumerik_modal_acts(sinumerik_of(interp)))
		return fault(&interp->at, block->code_column[SINUMERIK_SUPPRESSION],
			     "SUPA, G53 and G153 while %s is called behind each motion; MCALL first",
			     sinumerik_of(interp)->modal.name);
	if (circle && machine)
		return fault(&interp->at, block->code_column[SINUMERIK_SUPPRESSION],
			     "SUPA, G53 and G153 need G0 or G1, not a circle");
	if (is_thread(state->motion))
		return run_thread(interp, block, machine);
	return circle ? run_circle(interp, block) : run_line(interp, block, machine);
}
