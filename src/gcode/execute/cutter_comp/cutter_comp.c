#include "gcode/execute/cutter_comp/cutter_comp.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/math/math_functions.h"
#include "base/mem.h"
#include "base/units.h"
#include "gcode/execute/cutter_comp/comp_corner.h"
#include "gcode/execute/cutter_comp/comp_lookahead.h"
#include "gcode/execute/cutter_comp/comp_moves.h"
#include "gcode/execute/motion_commands.h"
#include "geom/tolerance.h"

/* Radians: LinuxCNC's TOLERANCE_CONCAVE_CORNER; a path that turns less counts as straight. */
#define STRAIGHT_ON 0.05

/* ---------------------------------------------------------------- corners */

/* The path of the waiting move; false: no move waits. */
static bool way_before(const struct interp *interp, struct plane_point corner, struct comp_way *way)
{
	const struct comp_queue *queue = &interp->comp.queue;
	struct plane_point current = interp->comp.current;
	double side = interp->comp.side, radius = interp->comp.radius;

	if (queue->count == 0)
		return false;
	*way = (struct comp_way){.point = current};
	/* The path is perpendicular to the line from the corner to the tool beside it. */
	way->direction =
	    (struct plane_point){side * (current.b - corner.b) / radius, -side * (current.a - corner.a) / radius};
	if (queue->items[0].kind != COMP_ARC)
		return true;
	way->is_arc = true;
	way->centre = queue->items[0].centre;
	way->clockwise = queue->items[0].clockwise;
	way->inside = (side > 0) != way->clockwise;
	way->radius = math_hypot(queue->items[0].end.a - way->centre.a, queue->items[0].end.b - way->centre.b);
	return true;
}

enum corner { CORNER_STRAIGHT_ON, CORNER_OUTSIDE, CORNER_INSIDE };

/*
 * The turn of the path from the present direction to `angle`: beta, -90 to 270 degrees, is positive if the tool moves
 * around the outside of the corner. A reversal is an outside corner, unless it is the point of an arc that the tool
 * follows outside.
 */
static enum corner turn_at(const struct interp *interp, struct plane_point corner, double angle, bool pointed,
			   double point_tolerance)
{
	struct plane_point current = interp->comp.current;
	double side = interp->comp.side;
	double before = math_atan2(current.b - corner.b, current.a - corner.a) - side * PI / 2;
	double beta = side * remainder(before - angle, 2 * PI);

	if (beta < -PI / 2)
		beta += 2 * PI;
	if (beta < -STRAIGHT_ON || beta > PI + STRAIGHT_ON)
		return CORNER_INSIDE;
	if (pointed && beta > PI - STRAIGHT_ON && beta < PI + point_tolerance)
		return CORNER_INSIDE;
	return beta > STRAIGHT_ON ? CORNER_OUTSIDE : CORNER_STRAIGHT_ON;
}

/* Ends the path before the corner at its intersection with the path after the corner. */
static bool meet(struct interp *interp, struct plane_point corner, const struct comp_way *after)
{
	int column = block_motion_column(&interp->block);
	struct plane_point end;
	struct comp_way before;

	if (!way_before(interp, corner, &before))
		return fault(&interp->at, column,
			     "an inside corner after a program stop under cutter compensation; the tool has already "
			     "gone too far");
	if (!comp_corner(&before, after, &end))
		return fault(&interp->at, column,
			     "an inside corner is too narrow for the tool (radius %.6g mm), which would gouge",
			     interp->comp.radius);
	return comp_send_to(interp, end);
}

/* Moves around the corner at the present height; a rapid moves straight. */
static bool go_round(struct interp *interp, struct plane_point corner, struct plane_point end,
		     const slot_values *target, const struct canon_move *move)
{
	struct comp_item item = {.centre = corner, .end = end, .clockwise = interp->comp.side > 0, .turns = 1};
	slot_values here = *target;
	enum axis_slot across = comp_slot_across(interp);
	bool good;

	here.v[across] = interp->state.position.v[across];
	if (move->kind == CANON_RAPID) {
		item = (struct comp_item){.kind = COMP_LINE, .end = end, .move = comp_complete(interp, move, &here)};
		good = motion_commands_enqueue(interp, &item);
	} else {
		good = comp_add_arc(interp, &here, move, &item);
	}
	if (!good || !comp_send_all(interp, end))
		return false;
	/* These axes have already moved to their end. */
	for (int slot = SLOT_A; slot < SLOT_COUNT; slot++)
		state_set_position(&interp->state, slot, target->v[slot]);
	return true;
}

/* ------------------------------------------------------------------ moves */

static bool enter_by_line(struct interp *interp, const slot_values *target, struct canon_move *move)
{
	struct cutter_comp *comp = &interp->comp;
	struct plane_point from = comp_here(interp), to = comp_point_of(interp, target);
	double beside_angle = math_atan2(to.b - from.b, to.a - from.a) + comp->side * PI / 2;
	struct plane_point aside = {math_cos(beside_angle), math_sin(beside_angle)};

	if (math_hypot(to.a - from.a, to.b - from.b) <= comp->radius)
		return fault(&interp->at, block_motion_column(&interp->block),
			     "the entry move of cutter compensation must be longer than the tool radius, %.6g mm",
			     comp->radius);
	comp->queue.start = from;
	return comp_add_line(interp, target, move, aside, comp_beside(to, comp->radius, beside_angle));
}

bool cutter_comp_line(struct interp *interp, const slot_values *target, struct canon_move *move)
{
	struct cutter_comp *comp = &interp->comp;
	struct plane_point from = comp_here(interp), to = comp_point_of(interp, target), mid;
	struct comp_way before = {.is_arc = false}, after = {.is_arc = false};
	double angle, length = math_hypot(to.a - from.a, to.b - from.b);
	bool pointed, good = true;

	if (comp->looks_ahead)
		return comp_lookahead_line(interp, target, move);
	if (!comp->entered)
		return enter_by_line(interp, target, move);
	if (!(length > 0))
		return comp_add_line(interp, target, move, (struct plane_point){0, 0}, comp->current);
	angle = math_atan2(to.b - from.b, to.a - from.a);
	mid = comp_beside(from, comp->radius, angle + comp->side * PI / 2);
	pointed = way_before(interp, from, &before) && before.is_arc && !before.inside;
	after.point = mid;
	after.direction = (struct plane_point){(to.a - from.a) / length, (to.b - from.b) / length};
	switch (turn_at(interp, from, angle, pointed, STRAIGHT_ON)) {
	case CORNER_INSIDE:
		good = meet(interp, from, &after);
		break;
	case CORNER_OUTSIDE:
		good = comp_send_to(interp, comp->current) && go_round(interp, from, mid, target, move);
		break;
	case CORNER_STRAIGHT_ON:
		good = comp_send_all(interp, comp->current);
		break;
	}
	return good && comp_add_line(interp, target, move, (struct plane_point){to.a - from.a, to.b - from.b},
				comp_beside(to, comp->radius, angle + comp->side * PI / 2));
}

/*
 * The tool moves from its present point to the point beside the programmed end, where the path has the direction of the
 * programmed arc: on an arc with another radius and centre.
 */
static bool enter_by_arc(struct interp *interp, const slot_values *target, struct comp_item *item, double aside,
			 struct canon_move *move)
{
	struct cutter_comp *comp = &interp->comp;
	struct plane_point from = comp_here(interp), to = comp_point_of(interp, target);
	struct plane_point end = comp_beside(to, comp->radius, aside), chord, radial;
	double radial_angle, part;

	if (math_hypot(to.a - from.a, to.b - from.b) <= comp->radius)
		return fault(&interp->at, block_motion_column(&interp->block),
			     "the entry arc of cutter compensation must end farther from its start than the tool "
			     "radius, %.6g mm",
			     comp->radius);
	radial_angle = math_atan2(item->centre.b - end.b, item->centre.a - end.a);
	radial = (struct plane_point){math_cos(radial_angle), math_sin(radial_angle)};
	chord = (struct plane_point){from.a - end.a, from.b - end.b};
	part = chord.a * radial.a + chord.b * radial.b;
	/* LinuxCNC's TOLERANCE_EQUAL. */
	if (fabs(part) < 0.0001 * math_hypot(chord.a, chord.b))
		return fault(&interp->at, block_motion_column(&interp->block),
			     "this arc cannot be the entry move of cutter compensation");
	part = (chord.a * chord.a + chord.b * chord.b) / (2 * part);
	item->centre = (struct plane_point){end.a + part * radial.a, end.b + part * radial.b};
	item->end = end;
	comp->queue.start = from;
	if (!comp_add_arc(interp, target, move, item))
		return false;
	comp_arrive(interp, target, end);
	return true;
}

bool cutter_comp_arc(struct interp *interp, const slot_values *target, struct plane_point centre, int turns,
		     struct canon_move *move)
{
	struct cutter_comp *comp = &interp->comp;
	struct plane_point from = comp_here(interp), to = comp_point_of(interp, target), end;
	bool clockwise = interp->block.motion == G2, inside = (comp->side > 0) != clockwise, good = true;
	double outward = math_atan2(to.b - centre.b, to.a - centre.a);
	double start = math_atan2(from.b - centre.b, from.a - centre.a);
	double radius = math_hypot(to.a - centre.a, to.b - centre.b);
	struct comp_item item = {.centre = centre, .clockwise = clockwise, .turns = turns};
	struct comp_way after = {.is_arc = true, .centre = centre, .clockwise = clockwise, .inside = inside};

	if (comp->looks_ahead)
		return comp_lookahead_arc(interp, target, centre, turns, move);
	if (inside && radius <= comp->radius)
		return fault(&interp->at, block_motion_column(&interp->block),
			     "the radius of the arc, %.6g mm, is not greater than the tool radius, %.6g mm", radius,
			     comp->radius);
	if (!comp->entered)
		return enter_by_arc(interp, target, &item, inside ? outward + PI : outward, move);
	end = comp_beside(to, comp->radius, inside ? outward + PI : outward);
	after.radius = math_hypot(end.a - centre.a, end.b - centre.b);
	switch (turn_at(interp, from, start + (clockwise ? -PI / 2 : PI / 2), !inside, STRAIGHT_ON)) {
	case CORNER_INSIDE:
		good = meet(interp, from, &after);
		break;
	case CORNER_OUTSIDE:
		good =
		    comp_send_all(interp, comp->current) &&
		    go_round(interp, from, comp_beside(from, comp->radius, inside ? start + PI : start), target, move);
		break;
	case CORNER_STRAIGHT_ON:
		good = comp_send_all(interp, comp->current);
		break;
	}
	item.end = end;
	item.programmed_sweep = fabs(arc_sweep(from, to, centre, clockwise, turns, SAME_POINT / radius));
	if (!good || !comp_add_arc(interp, target, move, &item))
		return false;
	comp_arrive(interp, target, end);
	return true;
}

/* ----------------------------------------------------------------- blocks */

/* The positions of axes that the block has moved are certain again; in turned coordinates it must move all axes. */
static void tighten(struct interp *interp)
{
	const struct block *block = &interp->block;
	double *loose = interp->comp.loose;
	int code = block->g[G_NONMODAL];
	bool moves = block->motion != CODE_NONE || code == G28 || code == G30;

	if (interp->comp.keeps_loose)
		return;
	for (int slot = SLOT_X; slot <= SLOT_Z && interp->state.frame.on; slot++)
		moves = moves && (!(loose[slot] > 0) || block_has(block, AXIS_LETTERS[slot]));
	for (int slot = SLOT_X; slot <= SLOT_Z && moves; slot++) {
		if (block_has(block, AXIS_LETTERS[slot]))
			loose[slot] = 0;
	}
}

/* Queues the end of a block whose moves wait for the end of a compensated move. */
static bool enqueue_end(struct interp *interp)
{
	const struct line_place *at = &interp->at;
	struct cutter_comp *comp = &interp->comp;
	struct comp_item item = {.kind = COMP_BLOCK,
				 .move = {.file = at->file, .line = at->line, .number = interp->moves},
				 .callers = interp->callers};

	comp->idle_blocks += comp->entered && !comp->moved;
	comp->moved = false;
	item.text = mem_strndup(at->text, strlen(at->text));
	if (motion_commands_enqueue(interp, &item))
		return true;
	free(item.text);
	return false;
}

bool cutter_comp_end_block(struct interp *interp)
{
	const struct line_place *at = &interp->at;

	tighten(interp);
	if (interp->comp.queue.count > 0)
		return enqueue_end(interp);
	return canon_tell_block(interp->sink, &(struct canon_block){at->file, at->line, at->text, interp->moves,
								   &interp->callers,
								   program_lines(&interp->program)});
}

bool cutter_comp_stop(struct interp *interp)
{
	const struct cutter_comp *comp = &interp->comp;
	int code = interp->block.m[M_STOP];

	if (!comp->queue.count)
		return true;
	if (comp->looks_ahead && code >= 97)
		return true;
	if (comp->looks_ahead && (comp->starting || code == 0 || code == 1))
		return fault(&interp->at, code == CODE_NONE ? 1 : interp->block.m_column[M_STOP],
			     "the program stops under cutter compensation: controls differ in where the tool waits; "
			     "write G40 first");
	return comp_send_to(interp, comp->current);
}
