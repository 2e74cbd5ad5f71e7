#include "gcode/execute/straight_move.h"

#include "base/apart.h"
#include "gcode/execute/corner_insert.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"
#include "gcode/execute/endpoint.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/tool_length.h"
#include "gcode/execute/tool_vector.h"

static bool go_in_program(struct interp *interp, struct canon_move *move)
{
	slot_values target;

	if (!endpoint_find(interp, false, &target) || (interp->block.vectors && !tool_vector_take(interp, &target)))
		return false;
	if (corner_insert_concerns(interp)) {
		bool waits = false;

		if (!corner_insert_pass(interp, &(struct corner_move){.target = &target, .move = move}, &waits) ||
		    waits)
			return waits;
	}
	return cutter_comp_is_on(interp) ? cutter_comp_line(interp, &target, move)
					 : motion_commands_go(interp, &target, move);
}

/* G53 suspends work offsets, turned coordinates, length compensation and TCP for one block. */
static APART bool go_in_machine(struct interp *interp, struct canon_move *move)
{
	const struct block *block = &interp->block;
	int column = block->g_column[G_NONMODAL];
	struct suspended suspended;
	bool named[SLOT_COUNT];
	bool incremental = interp->state.incremental, found;
	slot_values target;

	move->machine_coordinates = true;
	if (!tool_length_suspend(interp, column, &suspended))
		return false;
	/* A G53 that is ignored because the words are increments (G91) was removed from its block before. */
	interp->state.incremental = false;
	found = endpoint_find(interp, true, &target);
	interp->state.incremental = incremental;
	if (!found || !motion_commands_go(interp, &target, move) ||
	    !tool_length_resume(interp, column, &suspended))
		return false;
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		named[slot] = block_has(block, AXIS_LETTERS[slot]);
	tool_length_after_machine(interp, G53, named);
	return true;
}

/*
 * Fanuc B-64484EN, "Single Direction Positioning (G60)": every axis arrives from the same side, if necessary by an
 * overrun past its end. Haas, "G60": the same, setting 35. The sides are not known: the path is proved with every
 * overrun, and so is the box of all overruns at its end.
 */
static APART bool approach(struct interp *interp)
{
	const struct block *block = &interp->block;
	double overrun = interp->config->controller.overrun;
	int column = block->g_column[G_APPROACH];
	struct canon_move move = {.kind = CANON_RAPID};
	slot_values target;

	if (block->g[G_MOTION] == G0)
		interp->state.motion = G0;
	if (cutter_comp_is_on(interp) || interp->state.tcp != TCP_OFF || interp->state.frame.on)
		return fault(&interp->at, column,
			     "G60 with an active compensation or in changed coordinates is not supported; cancel these "
			     "first");
	if (!(overrun > 0))
		return fault(
		    &interp->at, column,
		    "G60 overruns its end point by a parameter of the control: set unidirectional_overrun=\"\" (in the "
		    "unit of the file) in the machine file's <controller>");
	if (!endpoint_find(interp, false, &target))
		return false;
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!block_has(block, AXIS_LETTERS[slot]))
			continue;
		if (slot > SLOT_Z)
			return fault(&interp->at, block_column(block, AXIS_LETTERS[slot]),
				     "%c with G60 is not supported", AXIS_LETTERS[slot]);
		move.spread[slot] = overrun;
		move.between[slot] = true;
	}
	if (!motion_commands_go(interp, &target, &move))
		return false;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		move.between[slot] = false;
	return motion_commands_go(interp, &target, &move);
}

bool straight_move_run(struct interp *interp)
{
	const struct block *block = &interp->block;
	const struct dialect_traits *traits = traits_of(interp);
	bool machine = block->g[G_NONMODAL] == G53, feeds = block->motion != G0;
	struct canon_move move;

	canon_move_begin(&move, CANON_RAPID);
	if (block->g[G_APPROACH] != CODE_NONE)
		return approach(interp);
	if (!machine || block->g[G_MOTION] != CODE_NONE)
		interp->state.motion = block->motion;
	if (machine && feeds &&
	    !is_answered(interp, block->g_column[G_NONMODAL], traits->g53_rate,
			 "whether G53 with G1 moves at the feed rate"))
		return false;
	if (machine && traits->g53_rate == G53_RATE_RAPID)
		feeds = false;
	if (feeds && !(block->letters & AXIS_BITS) && !block->vectors) {
		if (!is_answered(interp, block_motion_column(block), traits->empty_feed_move,
				 "whether G1 without an axis word needs a feed rate"))
			return false;
		if (traits->empty_feed_move == EMPTY_FEED_MOVE_IGNORED)
			return true;
	}
	if (feeds && !motion_commands_feed(interp, &move.feed))
		return false;
	move.kind = feeds ? CANON_FEED : CANON_RAPID;
	interp->comp.arc_refused = false;
	return machine ? go_in_machine(interp, &move) : go_in_program(interp, &move);
}
