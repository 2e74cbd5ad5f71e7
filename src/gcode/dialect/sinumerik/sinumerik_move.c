#include "gcode/dialect/sinumerik/sinumerik_move.h"

#include <math.h>

#include "base/same_double.h"
#include "gcode/dialect/sinumerik/sinumerik_circle.h"
#include "gcode/dialect/sinumerik/sinumerik_frame.h"
#include "gcode/dialect/sinumerik/sinumerik_orientation.h"
#include "gcode/dialect/sinumerik/sinumerik_target.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/tool_length.h"

#define CENTRE_BITS (letter_bit('I') | letter_bit('J') | letter_bit('K'))
#define VECTOR_BITS (1U << SINUMERIK_A3 | 1U << SINUMERIK_B3 | 1U << SINUMERIK_C3)
#define CIRCLE_BITS (1U << SINUMERIK_CR | 1U << SINUMERIK_AR | 1U << SINUMERIK_TURN | 1U << SINUMERIK_I1 | \
		     1U << SINUMERIK_J1 | 1U << SINUMERIK_K1)

/* ------------------------------------------------------------------- lines */

/* What the functions of the other dialects read of a block. */
static void show_block(struct interp *interp, const struct sinumerik_block *block, int motion)
{
	struct block *shown = &interp->block;

	shown->motion = motion;
	shown->g[G_MOTION] = motion;
	shown->g_column[G_MOTION] = block->code[SINUMERIK_MOTION] != CODE_NONE ? block->code_column[SINUMERIK_MOTION]
									       : sinumerik_block_axis_column(block);
	shown->letters = block->letters & letter_bit('F');
	if (shown->letters) {
		shown->value['F' - 'A'] = block->value['F' - 'A'];
		shown->column['F' - 'A'] = block->column['F' - 'A'];
	}
}

static bool arrive(struct interp *interp, const slot_values *target, struct canon_move *move)
{
	const slot_values straight = sinumerik_frame_straight(interp, target);

	if (!motion_commands_go(interp, &straight, move))
		return false;
	sinumerik_of(interp)->place = *target;
	sinumerik_of(interp)->placed = true;
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
	return arrive(interp, target, &move);
}

/*
 * 840D sl, "Suppression of frames": SUPA, G53 and G153 leave the tool's offsets in force. While TRAORI is on, what
 * they count from is not certain. A swivelled head turns the tool's length, so that only D0 makes it plain.
 */
static bool go_in_machine(struct interp *interp, const struct sinumerik_block *block, struct canon_move *move)
{
	const struct state *state = &interp->state;
	const int column = block->code_column[SINUMERIK_SUPPRESSION];
	struct suspended suspended;
	slot_values target;

	move->machine_coordinates = true;
	if (state->tcp == TCP_BY_LENGTH)
		return fault(&interp->at, column,
			     "positions of the machine's axes (SUPA, G53, G153) while TRAORI is on; TRAFOOF first");
	if (state->tcp == TCP_BY_PLANE && !same_double(state->length, 0))
		return fault(&interp->at, column,
			     "positions of the machine's axes (SUPA, G53, G153) with a tool's length while CYCLE800 has "
			     "swivelled; write D0 beside it");
	if (!tool_length_suspend(interp, column, &suspended) || !sinumerik_target_find_machine(interp, block, &target) ||
	    !motion_commands_go(interp, &target, move) || !tool_length_resume(interp, column, &suspended))
		return false;
	sinumerik_frame_moved(interp);
	sinumerik_frame_place(interp);
	return true;
}

static bool run_line(struct interp *interp, const struct sinumerik_block *block, bool machine)
{
	const bool rapid = interp->state.motion == G0;
	struct canon_move move = {.kind = rapid ? CANON_RAPID : CANON_FEED};
	slot_values target;

	if (!rapid && !motion_commands_feed(interp, &move.feed))
		return false;
	if (machine)
		return go_in_machine(interp, block, &move);
	if (!sinumerik_target_find(interp, block, &target))
		return false;
	if (interp->state.tcp == TCP_BY_LENGTH && !sinumerik_orientation_find(interp, block, &target))
		return false;
	return arrive(interp, &target, &move);
}

static bool run_circle(struct interp *interp, const struct sinumerik_block *block)
{
	struct canon_move move = {.kind = CANON_ARC};
	slot_values target;

	if (!motion_commands_feed(interp, &move.feed) || !sinumerik_target_find(interp, block, &target))
		return false;
	if (interp->state.tcp == TCP_BY_LENGTH && !sinumerik_orientation_find(interp, block, &target))
		return false;
	return sinumerik_circle_find(interp, block, &target, &move.arc) && arrive(interp, &target, &move);
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
	for (const char *letter = "IJK"; *letter && !circle; letter++) {
		if (sinumerik_block_has(block, *letter))
			return fault(&interp->at, block->column[*letter - 'A'], "%c belongs to a circle (G2, G3)",
				     *letter);
	}
	if ((block->addresses & VECTOR_BITS) && interp->state.tcp != TCP_BY_LENGTH)
		return fault(&interp->at, sinumerik_block_axis_column(block),
			     "A3=, B3= and C3= need TRAORI, which turns the tool into their direction");
	return true;
}

bool sinumerik_move_run(struct interp *interp, const struct sinumerik_block *block, bool *moved)
{
	const int given = block->code[SINUMERIK_MOTION];
	const bool machine = block->code[SINUMERIK_SUPPRESSION] != CODE_NONE;
	struct state *state = &interp->state;
	bool circle, axes;

	if (given != CODE_NONE)
		state->motion = given;
	circle = state->motion == G2 || state->motion == G3 || state->motion == SINUMERIK_CIP;
	axes = (block->letters & AXIS_BITS) || (block->addresses & VECTOR_BITS) ||
	       (circle && ((block->letters & CENTRE_BITS) || (block->addresses & CIRCLE_BITS)));
	*moved = false;
	if (!refuse_words(interp, block, circle))
		return false;
	if (!axes)
		return true;
	if (!sinumerik_target_check(interp, block, machine, circle))
		return false;
	*moved = !machine;
	show_block(interp, block, state->motion == SINUMERIK_CIP ? G2 : state->motion);
	if (circle && machine)
		return fault(&interp->at, block->code_column[SINUMERIK_SUPPRESSION],
			     "SUPA, G53 and G153 need G0 or G1, not a circle");
	return circle ? run_circle(interp, block) : run_line(interp, block, machine);
}
