#include "gcode/execute/length_change.h"

#include <math.h>

#include "gcode/execute/motion_commands.h"
#include "gcode/execute/rotated_frame.h"
#include "geom/tolerance.h"

slot_values length_change_place(const struct interp *interp)
{
	slot_values straight = rotated_frame_straight(&interp->state), place = {{0}};

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		place.v[slot] = straight.v[slot] - interp->state.offset.v[slot];
	return place;
}

/* Does the block move this axis to an absolute coordinate? */
static bool is_settled(const struct interp *interp, int slot)
{
	const struct block *block = &interp->block;
	int distance = block->g[G_DISTANCE];
	bool incremental = distance == CODE_NONE ? interp->state.incremental : distance == G91;
	bool straight = block->motion >= G0 && block->motion <= G3;

	return block_has(block, AXIS_LETTERS[slot]) && !incremental && straight && block->g[G_ROTATION] == CODE_NONE &&
	       (block->g[G_NONMODAL] == CODE_NONE || block->g[G_NONMODAL] == G53);
}

/* An axis whose end position the block does not determine, or -1. */
static int find_open(const struct interp *interp, const struct length_change *change)
{
	bool tcp = interp->state.tcp != TCP_OFF;

	for (int slot = SLOT_Z; slot >= SLOT_X; slot--) {
		/* The control may have cancelled the former length. */
		bool doubtful = change->doubt != CODE_NONE && (tcp || slot == SLOT_Z);

		if ((doubtful || fabs(change->shift.v[slot]) > SAME_COORDINATE) && !is_settled(interp, slot))
			return slot;
	}
	return -1;
}

/* Does the block move the axes only by the shift, or by the shift and a straight move? */
static bool is_plain(const struct interp *interp, const struct length_change *change)
{
	const struct block *block = &interp->block;
	int motion = block->motion == CODE_NONE ? interp->state.motion : block->motion;
	bool straight = motion == CODE_NONE || motion == G0 || motion == G1 || motion == G80;

	return straight && change->doubt == CODE_NONE && !change->ends_tcp && !interp->state.frame.waits_for_tool &&
	       block->g[G_NONMODAL] == CODE_NONE && block->g[G_ROTATION] == CODE_NONE;
}

/*
 * Fanuc 30i connection manual (B-63943EN-1), "Tool Length Compensation Shift Types": parameter 5006#6 (TOS) decides
 * whether the axes move or the coordinates are shifted; shifted coordinates move nothing without a move command.
 * Operator's manual, tool length compensation: axes that move do so by the block's increments plus the shift.
 */
bool length_change_settle(struct interp *interp, const struct length_change *change)
{
	struct state *state = &interp->state;
	int open = find_open(interp, change);

	if (open < 0 || interp->config->controller.length_moves == ANSWER_NO)
		return true;
	if (interp->config->controller.length_moves == ANSWER_UNKNOWN)
		return fault(&interp->at, change->column,
			     "controls differ in whether this change of the tool length moves %c at once: write %c in "
			     "this block as an absolute coordinate, or set length_offset_moves=\"yes\" or \"no\" in "
			     "the machine file's <controller>",
			     AXIS_LETTERS[open], AXIS_LETTERS[open]);
	if (!is_plain(interp, change))
		return fault(&interp->at, change->column,
			     "with length_offset_moves=\"yes\", this change of the tool length moves %c to an unknown "
			     "position; write %c in this block as an absolute coordinate of G0 or G1",
			     AXIS_LETTERS[open], AXIS_LETTERS[open]);
	state->length_moves = true;
	state->length_shift = change->shift;
	return true;
}

bool length_change_go(struct interp *interp)
{
	struct state *state = &interp->state;
	slot_values target;

	if (!state->length_moves || (interp->block.letters & AXIS_BITS))
		return true;
	target = rotated_frame_straight(state);
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		target.v[slot] += state->length_shift.v[slot];
	state->length_moves = false;
	return motion_commands_go(interp, &target, &(struct canon_move){.kind = CANON_RAPID});
}
