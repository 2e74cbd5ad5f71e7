#include "gcode/execute/cutter_comp/comp_moves.h"

#include "base/math/math_functions.h"
#include "base/units.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/polar_pieces.h"
#include "gcode/execute/rotated_frame.h"

/*
 * Radians: how much more than programmed a shortened arc may turn. LinuxCNC uses its tolerances in mm and inches as
 * radians.
 */
#define SLACK_MM 0.0254
#define SLACK_INCH 0.001

enum axis_slot comp_slot_a(const struct interp *interp)
{
	return interp->state.plane == G17 ? SLOT_X : interp->state.plane == G18 ? SLOT_Z : SLOT_Y;
}

enum axis_slot comp_slot_b(const struct interp *interp)
{
	return interp->state.plane == G17 ? SLOT_Y : interp->state.plane == G18 ? SLOT_X : SLOT_Z;
}

enum axis_slot comp_slot_across(const struct interp *interp)
{
	return interp->state.plane == G17 ? SLOT_Z : interp->state.plane == G18 ? SLOT_Y : SLOT_X;
}

struct plane_point comp_point_of(const struct interp *interp, const slot_values *values)
{
	return (struct plane_point){values->v[comp_slot_a(interp)], values->v[comp_slot_b(interp)]};
}

struct plane_point comp_here(const struct interp *interp)
{
	slot_values here = rotated_frame_straight(&interp->state);

	return comp_point_of(interp, &here);
}

struct plane_point comp_beside(struct plane_point from, double distance, double angle)
{
	return (struct plane_point){from.a + distance * math_cos(angle), from.b + distance * math_sin(angle)};
}

/* Converts a waiting move from straight coordinates (rotated_frame.h) to the controller's. */
static void turn_move(const struct state *state, struct canon_move *move)
{
	vec3 end = {move->end.v[SLOT_X], move->end.v[SLOT_Y], move->end.v[SLOT_Z]};

	if (!state->frame.on)
		return;
	end = rotated_frame_point(state, end);
	move->end.v[SLOT_X] = end.x;
	move->end.v[SLOT_Y] = end.y;
	move->end.v[SLOT_Z] = end.z;
	move->arc.centre = rotated_frame_point(state, move->arc.centre);
	move->arc.normal = rotated_frame_normal(state, move->arc.normal);
}

/* Sends an item that has waited. */
static bool tell_item(struct interp *interp, const struct comp_item *item)
{
	struct canon_move move = item->move;

	if (item->kind == COMP_BLOCK)
		return canon_tell_block(interp->sink, &(struct canon_block){move.file, move.line, item->text,
									    move.number, &item->callers,
									    program_lines(&interp->program)});
	move.origin = &item->origin;
	if (item->kind != COMP_PAUSE)
		turn_move(&interp->state, &move);
	return polar_pieces_tell(interp, &move);
}

bool comp_send_all(struct interp *interp, struct plane_point start)
{
	struct comp_queue queue = interp->comp.queue;
	bool good = true;

	interp->comp.queue = (struct comp_queue){.start = start};
	comp_queue_settle(&queue, comp_slot_a(interp), comp_slot_b(interp));
	for (size_t i = 0; i < queue.count && good; i++)
		good = tell_item(interp, &queue.items[i]);
	comp_queue_release(&queue);
	return good;
}

static bool fault_of_end(struct interp *interp, enum comp_end end, const struct comp_item *item)
{
	struct line_place at = interp->at;
	const char *what = item->kind == COMP_ARC ? "arc" : item->move.kind == CANON_RAPID ? "rapid" : "straight feed";
	int column = block_motion_column(&interp->block);

	/* G40, or a stop. */
	if (column == 0)
		column = interp->block.g[G_CUTTER] == CODE_NONE ? 1 : interp->block.g_column[G_CUTTER];
	if (end == COMP_END_OFF_ARC)
		return fault(&at, column, "the arc of line %ld cannot be compensated: its radii differ",
			     item->move.line);
	return fault(&at, column,
		     "the %s of line %ld ends in an inside corner that is too narrow for the tool (radius %.6g mm), "
		     "which would gouge",
		     what, item->move.line, interp->comp.radius);
}

bool comp_send_to(struct interp *interp, struct plane_point end)
{
	double slack = interp->state.scale > 1 ? SLACK_INCH : SLACK_MM;
	const struct comp_item *faulty = NULL;
	enum comp_end status = comp_queue_end_at(&interp->comp.queue, end, slack, &faulty);

	if (status != COMP_END_GOOD)
		return fault_of_end(interp, status, faulty);
	return comp_send_all(interp, end);
}

struct canon_move comp_complete(struct interp *interp, const struct canon_move *move, const slot_values *target)
{
	struct canon_move full = *move;

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		full.end.v[slot] = slot_is_rotary(slot) ? radians(target->v[slot]) : target->v[slot];
	motion_commands_fill(interp, &full);
	return full;
}

void comp_arrive(struct interp *interp, const slot_values *target, struct plane_point current)
{
	slot_values position = rotated_frame_position(&interp->state, target);

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		state_set_position(&interp->state, slot, position.v[slot]);
	interp->comp.current = current;
	interp->comp.entered = true;
}

bool comp_add_line(struct interp *interp, const slot_values *target, const struct canon_move *move,
		   struct plane_point direction, struct plane_point end)
{
	struct comp_item item = {
	    .kind = COMP_LINE, .move = comp_complete(interp, move, target), .direction = direction, .end = end};

	if (!motion_commands_enqueue(interp, &item))
		return false;
	comp_arrive(interp, target, end);
	return true;
}

/* The arc of a canonical move: the centre is at the height of the start. */
static struct canon_arc space_arc(const struct interp *interp, struct plane_point centre)
{
	slot_values here = rotated_frame_straight(&interp->state);
	double xyz[3] = {here.v[SLOT_X], here.v[SLOT_Y], here.v[SLOT_Z]}, normal[3] = {0};

	xyz[comp_slot_a(interp)] = centre.a;
	xyz[comp_slot_b(interp)] = centre.b;
	normal[comp_slot_across(interp)] = 1;
	return (struct canon_arc){.centre = {xyz[0], xyz[1], xyz[2]}, .normal = {normal[0], normal[1], normal[2]}};
}

bool comp_add_arc(struct interp *interp, const slot_values *target, const struct canon_move *move,
		  struct comp_item *item)
{
	item->kind = COMP_ARC;
	item->move = comp_complete(interp, move, target);
	item->move.kind = CANON_ARC;
	item->move.arc = space_arc(interp, item->centre);
	return motion_commands_enqueue(interp, item);
}
