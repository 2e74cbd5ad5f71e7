#include "gcode/execute/reference_return.h"

#include <math.h>

#include "gcode/execute/dynamic_work_offset.h"
#include "gcode/execute/endpoint.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/tool_length.h"

static bool go_rapid(struct interp *interp, const slot_values *target)
{
	return motion_commands_go(interp, target, &(struct canon_move){.kind = CANON_RAPID});
}

static bool go_in_machine(struct interp *interp, const slot_values *target)
{
	return motion_commands_go(interp, target,
				  &(struct canon_move){.kind = CANON_RAPID, .machine_coordinates = true});
}

static bool is_named(const struct interp *interp, int slot)
{
	bool all = !(interp->block.letters & AXIS_BITS);

	return interp->config->has_axis[slot] && (all || block_has(&interp->block, AXIS_LETTERS[slot]));
}

/*
 * Moves the marked axes to a place of the machine: first those with an order in the place, one after another, then the
 * others together.
 */
static bool go_to_place(struct interp *interp, const struct control_place *place, const slot_values *values,
			const bool moves[SLOT_COUNT], int column)
{
	slot_values target = interp->state.position;
	bool left = false, done[SLOT_COUNT] = {false};

	for (size_t i = 0; i < place->order_count; i++) {
		int slot = place->order[i];

		if (!moves[slot])
			continue;
		done[slot] = interp->state.settles[slot] = true;
		if (!endpoint_absolute(interp, slot, values->v[slot], 0, column, &target.v[slot]) ||
		    !go_in_machine(interp, &target))
			return false;
	}
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!moves[slot] || done[slot])
			continue;
		left = interp->state.settles[slot] = true;
		if (!endpoint_absolute(interp, slot, values->v[slot], 0, column, &target.v[slot]))
			return false;
	}
	return !left || go_in_machine(interp, &target);
}

/* The index of the four reference positions: G28 uses the first, G30 the second or that of its P. */
static bool find_number(struct interp *interp, int *index)
{
	const struct block *block = &interp->block;
	const struct dialect_traits *traits = traits_of(interp);
	bool by_p = block_has(block, 'P') && traits->g30_has_number != ANSWER_NO;
	int number = 2;

	*index = 0;
	if (block->g[G_NONMODAL] == G28)
		return true;
	if (by_p && (!is_answered(interp, block_column(block, 'P'), traits->g30_has_number,
				  "whether P of G30 is the number of a reference position") ||
		     !block_integer(block, &interp->at, 'P', 2, REFERENCES_MAX, &number)))
		return false;
	*index = number - 1;
	if (interp->config->controller.references[*index].given ||
	    (number == 2 && traits->references_in_parameters == ANSWER_YES))
		return true;
	return fault(&interp->at, by_p ? block_column(block, 'P') : block->g_column[G_NONMODAL],
		     "the machine file has no reference position %d: set <reference number=\"%d\" X=\"\" .../> in its "
		     "<controller>",
		     number, number);
}

static slot_values place_values(const struct interp *interp, int index)
{
	slot_values values;

	if (index < 2)
		return interp->state.reference[index];
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		values.v[slot] = state_from_canonical(slot, interp->config->controller.references[index].value.v[slot]);
	return values;
}

/* Haas mill operator's manual, "G254 Dynamic Work Offset": G28 ignores it. */
static bool go_on_the_way(struct interp *interp)
{
	slot_values target;
	bool suspended, good;

	dynamic_work_offset_suspend(&interp->state, &suspended);
	good = endpoint_find(interp, false, &target);
	dynamic_work_offset_resume(&interp->state, suspended);
	return good && go_rapid(interp, &target);
}

/*
 * LinuxCNC's manual, "G28, G28.1"; Fanuc 30i-B operator's manual, reference position return; Haas, G28: one rapid to
 * the point of the axis words, then the named axes, or all axes if none is named, move to the reference position.
 */
bool reference_return_go(struct interp *interp)
{
	const struct block *block = &interp->block;
	int column = block->g_column[G_NONMODAL], index;
	struct suspended suspended;
	slot_values values;
	bool moves[SLOT_COUNT];

	if (!find_number(interp, &index))
		return false;
	values = place_values(interp, index);
	if ((block->letters & AXIS_BITS) && !go_on_the_way(interp))
		return false;
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		moves[slot] = is_named(interp, slot);
	if (!tool_length_suspend(interp, column, &suspended) ||
	    !go_to_place(interp, &interp->config->controller.references[index], &values, moves, column) ||
	    !tool_length_resume(interp, column, &suspended))
		return false;
	tool_length_after_machine(interp, block->g[G_NONMODAL], moves);
	return true;
}

bool reference_return_remember(struct interp *interp)
{
	const struct block *block = &interp->block;
	int column = block->g_column[G_NONMODAL], index = block->g[G_NONMODAL] == G30_1;
	struct suspended suspended;

	if (!tool_length_suspend(interp, column, &suspended))
		return false;
	interp->state.reference[index] = interp->state.position;
	/* LinuxCNC keeps the reference of a wrapped axis within one turn. */
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		double *angle = &interp->state.reference[index].v[slot];

		if (interp->config->wrap[slot] != WRAP_NONE)
			*angle -= 360 * floor(*angle / 360);
	}
	return tool_length_resume(interp, column, &suspended);
}

/*
 * Haas mill operator's manual, "M06 Tool Change": the control moves Z to its home. On Fanuc controls the machine
 * builder defines M6.
 */
static bool fault_no_place(struct interp *interp, int column)
{
	return fault(&interp->at, column,
		     "it is not known where M6 moves the axes: set <tool_change Z=\"\" .../>, or <tool_change/> if it "
		     "moves none, in the machine file's <controller>");
}

bool reference_return_change_tool(struct interp *interp)
{
	const struct control_place *place = &interp->config->controller.tool_change;
	int column = interp->block.m_column[M_TOOL];
	struct suspended suspended;
	slot_values values;
	bool moves[SLOT_COUNT];

	if (!place->given)
		return traits_of(interp)->tool_change_stays == ANSWER_YES || fault_no_place(interp, column);
	if (interp->state.frame.on && interp->state.tcp == TCP_BY_PLANE) {
		for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
			if (place->has[slot])
				return fault(&interp->at, column,
					     "M6 while G68.2 is active turns %c away from its plane; write G69 first",
					     AXIS_LETTERS[slot]);
		}
	}
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		values.v[slot] = state_from_canonical(slot, place->value.v[slot]);
		moves[slot] = place->has[slot];
	}
	if (!tool_length_suspend(interp, column, &suspended) || !go_to_place(interp, place, &values, moves, column) ||
	    !tool_length_resume(interp, column, &suspended))
		return false;
	tool_length_after_machine(interp, DOUBT_M6, moves);
	return true;
}
