#include "gcode/execute/cutter_comp/cutter_comp.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "base/units.h"
#include "gcode/execute/cutter_comp/comp_corner.h"
#include "gcode/execute/motion_commands.h"
#include "geom/tolerance.h"

/* Radians: LinuxCNC's TOLERANCE_CONCAVE_CORNER; a path that turns less goes straight on. */
#define STRAIGHT_ON 0.05

/*
 * Radians: how much farther than programmed a trimmed arc may turn. LinuxCNC uses
 * its figures for mm and inches as radians.
 */
#define SLACK_MM 0.0254
#define SLACK_INCH 0.001

static enum axis_slot slot_a(const struct interp *interp)
{
	return interp->state.plane == G18 ? SLOT_Z : SLOT_X;
}

static enum axis_slot slot_b(const struct interp *interp)
{
	return interp->state.plane == G18 ? SLOT_X : SLOT_Y;
}

static enum axis_slot slot_across(const struct interp *interp)
{
	return interp->state.plane == G18 ? SLOT_Y : SLOT_Z;
}

static struct plane_point point_of(const struct interp *interp, const slot_values *values)
{
	return (struct plane_point){values->v[slot_a(interp)], values->v[slot_b(interp)]};
}

/* The point at this distance and angle from `from`. */
static struct plane_point beside(struct plane_point from, double distance, double angle)
{
	return (struct plane_point){from.a + distance * cos(angle), from.b + distance * sin(angle)};
}

/* ------------------------------------------------------------------ queue */

/* An item that waited. */
static bool tell_item(struct interp *interp, const struct comp_item *item)
{
	const struct canon_move *move = &item->move;

	if (item->kind != COMP_BLOCK)
		return canon_tell_move(interp->sink, move);
	return canon_tell_block(interp->sink, &(struct canon_block){move->file, move->line, item->text, move->number});
}

/* Sends everything that waits, with its present ends; the next move starts at `start`. */
static bool send_all(struct interp *interp, struct plane_point start)
{
	struct comp_queue queue = interp->comp.queue;
	bool good = true;

	interp->comp.queue = (struct comp_queue){.start = start};
	comp_queue_settle(&queue, slot_a(interp), slot_b(interp));
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
		return fault(&at, column, "the compensated arc of line %ld cannot be made: its radii differ",
			     item->move.line);
	return fault(&at, column,
		     "the %s of line %ld ends in an inside corner that the tool (radius %.6g mm) cannot "
		     "reach without gouging",
		     what, item->move.line, interp->comp.radius);
}

/* Ends everything that waits at this point and sends it. */
static bool send_to(struct interp *interp, struct plane_point end)
{
	double slack = interp->state.scale > 1 ? SLACK_INCH : SLACK_MM;
	const struct comp_item *faulty = NULL;
	enum comp_end status = comp_queue_end_at(&interp->comp.queue, end, slack, &faulty);

	if (status != COMP_END_GOOD)
		return fault_of_end(interp, status, faulty);
	return send_all(interp, end);
}

/* Fills in what the block says about a move, and its end on the axes off the plane. */
static struct canon_move complete(struct interp *interp, const struct canon_move *move, const slot_values *target)
{
	struct canon_move full = *move;

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		full.end.v[slot] = slot_is_rotary(slot) ? radians(target->v[slot]) : target->v[slot];
	motion_commands_fill(interp, &full);
	return full;
}

/* Takes the programmed position as the present one; only the axes off the plane are really there. */
static void arrive(struct interp *interp, const slot_values *target, struct plane_point current)
{
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		state_set_position(&interp->state, slot, target->v[slot]);
	interp->comp.current = current;
	interp->comp.entered = true;
}

static bool add_line(struct interp *interp, const slot_values *target, const struct canon_move *move,
		     struct plane_point direction, struct plane_point end)
{
	struct comp_item item = {
	    .kind = COMP_LINE, .move = complete(interp, move, target), .direction = direction, .end = end};

	if (!motion_commands_enqueue(interp, &item))
		return false;
	arrive(interp, target, end);
	return true;
}

/* The arc as a canonical move has it: the centre at the height of the start. */
static struct canon_arc space_arc(const struct interp *interp, struct plane_point centre)
{
	double xyz[3] = {0};

	xyz[slot_a(interp)] = centre.a;
	xyz[slot_b(interp)] = centre.b;
	xyz[slot_across(interp)] = interp->state.position.v[slot_across(interp)];
	return (struct canon_arc){.centre = {xyz[0], xyz[1], xyz[2]},
				  .normal = interp->state.plane == G18 ? (vec3){0, 1, 0} : (vec3){0, 0, 1}};
}

/* add_line for an arc; the item has its centre, direction and turns already. */
static bool add_arc(struct interp *interp, const slot_values *target, const struct canon_move *move,
		    struct comp_item *item)
{
	item->kind = COMP_ARC;
	item->move = complete(interp, move, target);
	item->move.kind = CANON_ARC;
	item->move.arc = space_arc(interp, item->centre);
	return motion_commands_enqueue(interp, item);
}

/* ---------------------------------------------------------------- corners */

/* The path of the move that waits; false: none waits. */
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
	way->radius = hypot(queue->items[0].end.a - way->centre.a, queue->items[0].end.b - way->centre.b);
	return true;
}

enum corner { CORNER_STRAIGHT_ON, CORNER_OUTSIDE, CORNER_INSIDE };

/*
 * How the path turns from the present direction to `angle`: beta, -90 to 270 degrees,
 * is positive where the tool goes round the corner. A reversal is an outside
 * corner, unless it is the point of an arc that the tool follows outside.
 */
static enum corner turn_at(const struct interp *interp, struct plane_point corner, double angle, bool pointed,
			   double point_tolerance)
{
	struct plane_point current = interp->comp.current;
	double side = interp->comp.side;
	double before = atan2(current.b - corner.b, current.a - corner.a) - side * PI / 2;
	double beta = side * remainder(before - angle, 2 * PI);

	if (beta < -PI / 2)
		beta += 2 * PI;
	if (beta < -STRAIGHT_ON || beta > PI + STRAIGHT_ON)
		return CORNER_INSIDE;
	if (pointed && beta > PI - STRAIGHT_ON && beta < PI + point_tolerance)
		return CORNER_INSIDE;
	return beta > STRAIGHT_ON ? CORNER_OUTSIDE : CORNER_STRAIGHT_ON;
}

/* Ends the path before where the path after crosses it. */
static bool meet(struct interp *interp, struct plane_point corner, const struct comp_way *after)
{
	int column = block_motion_column(&interp->block);
	struct plane_point end;
	struct comp_way before;

	if (!way_before(interp, corner, &before))
		return fault(&interp->at, column,
			     "an inside corner after a stop of the program under cutter "
			     "compensation; the tool has gone too far already");
	if (!comp_corner(&before, after, &end))
		return fault(&interp->at, column,
			     "an inside corner that the tool (radius %.6g mm) cannot reach "
			     "without gouging",
			     interp->comp.radius);
	return send_to(interp, end);
}

/* Goes round the corner at the present height; a rapid goes straight across. */
static bool go_round(struct interp *interp, struct plane_point corner, struct plane_point end,
		     const slot_values *target, const struct canon_move *move)
{
	struct comp_item item = {.centre = corner, .end = end, .clockwise = interp->comp.side > 0, .turns = 1};
	slot_values here = *target;
	enum axis_slot across = slot_across(interp);
	bool good;

	here.v[across] = interp->state.position.v[across];
	if (move->kind == CANON_RAPID) {
		item = (struct comp_item){.kind = COMP_LINE, .end = end, .move = complete(interp, move, &here)};
		good = motion_commands_enqueue(interp, &item);
	} else {
		good = add_arc(interp, &here, move, &item);
	}
	if (!good || !send_all(interp, end))
		return false;
	/* These axes are taken to their end already. */
	for (int slot = SLOT_A; slot < SLOT_COUNT; slot++)
		state_set_position(&interp->state, slot, target->v[slot]);
	return true;
}

/* ------------------------------------------------------------------ moves */

static bool enter_by_line(struct interp *interp, const slot_values *target, struct canon_move *move)
{
	struct cutter_comp *comp = &interp->comp;
	struct plane_point from = point_of(interp, &interp->state.position), to = point_of(interp, target);
	double beside_angle = atan2(to.b - from.b, to.a - from.a) + comp->side * PI / 2;
	struct plane_point aside = {cos(beside_angle), sin(beside_angle)};

	if (hypot(to.a - from.a, to.b - from.b) <= comp->radius)
		return fault(&interp->at, block_motion_column(&interp->block),
			     "the entry move of cutter compensation is not longer than the tool's radius, %.6g mm",
			     comp->radius);
	comp->queue.start = from;
	return add_line(interp, target, move, aside, beside(to, comp->radius, beside_angle));
}

bool cutter_comp_line(struct interp *interp, const slot_values *target, struct canon_move *move)
{
	struct cutter_comp *comp = &interp->comp;
	struct plane_point from = point_of(interp, &interp->state.position), to = point_of(interp, target), mid;
	struct comp_way before = {.is_arc = false}, after = {.is_arc = false};
	double angle, length = hypot(to.a - from.a, to.b - from.b);
	bool pointed, good = true;

	if (!comp->entered)
		return enter_by_line(interp, target, move);
	if (!(length > 0))
		return add_line(interp, target, move, (struct plane_point){0, 0}, comp->current);
	angle = atan2(to.b - from.b, to.a - from.a);
	mid = beside(from, comp->radius, angle + comp->side * PI / 2);
	pointed = way_before(interp, from, &before) && before.is_arc && !before.inside;
	after.point = mid;
	after.direction = (struct plane_point){(to.a - from.a) / length, (to.b - from.b) / length};
	switch (turn_at(interp, from, angle, pointed, STRAIGHT_ON)) {
	case CORNER_INSIDE:
		good = meet(interp, from, &after);
		break;
	case CORNER_OUTSIDE:
		good = send_to(interp, comp->current) && go_round(interp, from, mid, target, move);
		break;
	case CORNER_STRAIGHT_ON:
		good = send_all(interp, comp->current);
		break;
	}
	return good && add_line(interp, target, move, (struct plane_point){to.a - from.a, to.b - from.b},
				beside(to, comp->radius, angle + comp->side * PI / 2));
}

/*
 * The tool moves from its point to the side of the programmed end, where it has the
 * direction of the programmed arc: an arc with another radius and centre.
 */
static bool enter_by_arc(struct interp *interp, const slot_values *target, struct comp_item *item, double aside,
			 struct canon_move *move)
{
	struct cutter_comp *comp = &interp->comp;
	struct plane_point from = point_of(interp, &interp->state.position), to = point_of(interp, target);
	struct plane_point end = beside(to, comp->radius, aside), chord, radial;
	double radial_angle, part;

	if (hypot(to.a - from.a, to.b - from.b) <= comp->radius)
		return fault(&interp->at, block_motion_column(&interp->block),
			     "the entry arc of cutter compensation does not reach farther than the tool's radius, "
			     "%.6g mm",
			     comp->radius);
	radial_angle = atan2(item->centre.b - end.b, item->centre.a - end.a);
	radial = (struct plane_point){cos(radial_angle), sin(radial_angle)};
	chord = (struct plane_point){from.a - end.a, from.b - end.b};
	part = chord.a * radial.a + chord.b * radial.b;
	/* LinuxCNC's TOLERANCE_EQUAL. */
	if (fabs(part) < 0.0001 * hypot(chord.a, chord.b))
		return fault(&interp->at, block_motion_column(&interp->block),
			     "this arc cannot be the entry move of cutter compensation");
	part = (chord.a * chord.a + chord.b * chord.b) / (2 * part);
	item->centre = (struct plane_point){end.a + part * radial.a, end.b + part * radial.b};
	item->end = end;
	comp->queue.start = from;
	if (!add_arc(interp, target, move, item))
		return false;
	arrive(interp, target, end);
	return true;
}

bool cutter_comp_arc(struct interp *interp, const slot_values *target, struct plane_point centre, int turns,
		     struct canon_move *move)
{
	struct cutter_comp *comp = &interp->comp;
	struct plane_point from = point_of(interp, &interp->state.position), to = point_of(interp, target), end;
	bool clockwise = interp->block.motion == G2, inside = (comp->side > 0) != clockwise, good = true;
	double outward = atan2(to.b - centre.b, to.a - centre.a), start = atan2(from.b - centre.b, from.a - centre.a);
	double radius = hypot(to.a - centre.a, to.b - centre.b);
	struct comp_item item = {.centre = centre, .clockwise = clockwise, .turns = turns};
	struct comp_way after = {.is_arc = true, .centre = centre, .clockwise = clockwise, .inside = inside};

	if (inside && radius <= comp->radius)
		return fault(&interp->at, block_motion_column(&interp->block),
			     "the arc's radius, %.6g mm, is not greater than the tool's, %.6g mm", radius,
			     comp->radius);
	if (!comp->entered)
		return enter_by_arc(interp, target, &item, inside ? outward + PI : outward, move);
	end = beside(to, comp->radius, inside ? outward + PI : outward);
	after.radius = hypot(end.a - centre.a, end.b - centre.b);
	switch (turn_at(interp, from, start + (clockwise ? -PI / 2 : PI / 2), !inside, STRAIGHT_ON)) {
	case CORNER_INSIDE:
		good = meet(interp, from, &after);
		break;
	case CORNER_OUTSIDE:
		good = send_all(interp, comp->current) &&
		       go_round(interp, from, beside(from, comp->radius, inside ? start + PI : start), target, move);
		break;
	case CORNER_STRAIGHT_ON:
		good = send_all(interp, comp->current);
		break;
	}
	item.end = end;
	item.programmed_sweep = fabs(arc_sweep(from, to, centre, clockwise, turns, SAME_POINT / radius));
	if (!good || !add_arc(interp, target, move, &item))
		return false;
	arrive(interp, target, end);
	return true;
}

/* ------------------------------------------------------------------ codes */

bool cutter_comp_select(struct interp *interp)
{
	struct cutter_comp *comp = &interp->comp;
	int code = interp->block.g[G_CUTTER];

	if (code == CODE_NONE)
		return true;
	if (code != G40)
		return cutter_comp_switch_on(interp);
	if (comp->entered) {
		if (!send_to(interp, comp->current))
			return false;
		comp->arc_refused = true;
	}
	comp->side = 0;
	comp->entered = false;
	return true;
}

bool cutter_comp_end_block(struct interp *interp)
{
	const struct line_place *at = &interp->at;
	struct comp_item item = {.kind = COMP_BLOCK,
				 .move = {.file = at->file, .line = at->line, .number = interp->moves}};

	if (!interp->comp.queue.count)
		return canon_tell_block(interp->sink,
					&(struct canon_block){at->file, at->line, at->text, interp->moves});
	item.text = mem_strndup(at->text, strlen(at->text));
	if (motion_commands_enqueue(interp, &item))
		return true;
	free(item.text);
	return false;
}

bool cutter_comp_stop(struct interp *interp)
{
	return !interp->comp.queue.count || send_to(interp, interp->comp.current);
}
