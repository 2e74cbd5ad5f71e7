#include "gcode/execute/cutter_comp/comp_lookahead.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/units.h"
#include "gcode/execute/cutter_comp/comp_moves.h"
#include "gcode/execute/cutter_comp/comp_turn.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/rotated_frame.h"
#include "geom/tolerance.h"

/* A block without a move in the plane may stand between two others. How many more is a parameter's business. */
#define IDLE_BLOCKS_MAX 1

static struct plane_point direction_of(struct plane_point from, struct plane_point to)
{
	double length = math_hypot(to.a - from.a, to.b - from.b);

	return (struct plane_point){(to.a - from.a) / length, (to.b - from.b) / length};
}

/* The direction of an arc at a point of it. */
static struct plane_point tangent(struct plane_point centre, struct plane_point at, bool clockwise)
{
	struct plane_point radial = direction_of(centre, at);

	return clockwise ? (struct plane_point){radial.b, -radial.a} : (struct plane_point){-radial.b, radial.a};
}

static double distance(struct plane_point p, struct plane_point q)
{
	return math_hypot(p.a - q.a, p.b - q.b);
}

static int column_of(const struct interp *interp)
{
	int column = block_motion_column(&interp->block);

	return column ? column : interp->block.g_column[G_CUTTER];
}

/* The block's distance perpendicular to the plane. */
static double way_across(const struct interp *interp, const slot_values *target)
{
	slot_values here = rotated_frame_straight(&interp->state);
	enum axis_slot across = comp_slot_across(interp);

	return fabs(target->v[across] - here.v[across]);
}

static void spread_in_plane(const struct interp *interp, struct canon_move *move, double spread)
{
	move->spread[comp_slot_a(interp)] += spread;
	move->spread[comp_slot_b(interp)] += spread;
}

/* In turned coordinates, and on a turned table, the plane may have any direction. */
static void cover_frame(const struct interp *interp, struct canon_move *move)
{
	double most = 0;

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		most = fmax(most, move->spread[slot]);
	for (int slot = SLOT_X; slot <= SLOT_Z && (interp->state.frame.on || interp->state.tcp != TCP_OFF); slot++)
		move->spread[slot] = sqrt(2) * most * (interp->state.frame.distorts ? interp->state.frame.growth : 1);
}

static bool check_idle_blocks(struct interp *interp)
{
	const int told = interp->config->controller.comp_idle_blocks, most = told > 0 ? told : IDLE_BLOCKS_MAX;
	const char *parameter = interp->config->dialect->traits.idle_blocks_parameter;

	if (interp->comp.idle_blocks <= most)
		return true;
	if (told == 0 && parameter)
		return fault(&interp->at, column_of(interp),
			     "%d blocks without a move in the plane of cutter compensation before this block, and a "
			     "parameter of the control (%s) decides how many it looks past: set "
			     "cutter_comp_idle_blocks=\"\" in the machine file's <controller>",
			     interp->comp.idle_blocks, parameter);
	return fault(&interp->at, column_of(interp),
		     "%d blocks without a move in the plane of cutter compensation before this block: the path depends "
		     "on how many the control looks past; write at most %d such blocks in a row",
		     interp->comp.idle_blocks, most);
}

static bool check_axes(struct interp *interp, const slot_values *target)
{
	const struct state *state = &interp->state;

	for (int slot = SLOT_A; slot < SLOT_COUNT; slot++) {
		if (fabs(target->v[slot] - state->position.v[slot]) > SAME_DEGREES)
			return fault(&interp->at, block_column(&interp->block, AXIS_LETTERS[slot]),
				     "%c under cutter compensation is not supported; write G40 first",
				     AXIS_LETTERS[slot]);
	}
	return check_idle_blocks(interp);
}

/* ---------------------------------------------------------------- corners */

/* Adds the uncertainty of the corner to the spread of the waiting moves before it. */
static void spread_waiting(struct interp *interp, const struct comp_turn *turn, double *across)
{
	struct comp_queue *queue = &interp->comp.queue;
	double wide = 0;

	for (int i = 1; i < turn->count; i++)
		wide = fmax(wide, distance(turn->points[0], turn->points[i]));
	*across = turn->count > 1 || turn->spread > 0 ? interp->comp.across : 0;
	for (size_t i = 0; i < queue->count; i++) {
		struct comp_item *item = &queue->items[i];
		bool first = i == 0;

		if (item->kind != COMP_LINE && item->kind != COMP_ARC)
			continue;
		spread_in_plane(interp, &item->move, first ? turn->spread_before : turn->spread_before + wide);
		if (first)
			item->move.spread[comp_slot_across(interp)] += *across;
		cover_frame(interp, &item->move);
	}
}

/* Makes the moves from the end of a block to the start of the next one: lines, or the arc about the corner. */
static bool go_round(struct interp *interp, const struct comp_turn *turn, double across, const struct canon_move *move)
{
	slot_values here = rotated_frame_straight(&interp->state);
	bool good = true;

	for (int i = 1; i < turn->count && good; i++) {
		struct comp_item item = {
		    .centre = turn->corner, .end = turn->points[i], .clockwise = interp->comp.side > 0, .turns = 1};
		struct canon_move round = *move;

		round.kind = move->kind == CANON_ARC ? CANON_FEED : move->kind;
		spread_in_plane(interp, &round, turn->spread);
		round.spread[comp_slot_across(interp)] += across;
		cover_frame(interp, &round);
		if (turn->on_arc && move->kind != CANON_RAPID) {
			good = comp_add_arc(interp, &here, &round, &item);
		} else {
			item = (struct comp_item){
			    .kind = COMP_LINE, .end = turn->points[i], .move = comp_complete(interp, &round, &here)};
			good = motion_commands_enqueue(interp, &item);
		}
		good = good && comp_send_all(interp, turn->points[i]);
	}
	return good;
}

/*
 * Ends the waiting block, moves around the corner, and makes the next move start after it. `after` is the programmed
 * path of the next block.
 */
static bool pass_corner(struct interp *interp, const struct comp_way *after, double next_across,
			struct canon_move *move)
{
	struct cutter_comp *comp = &interp->comp;
	struct comp_turn turn;
	double across = 0;

	if (!comp_turn_find(interp, after, &turn))
		return false;
	spread_waiting(interp, &turn, &across);
	if (!comp_send_to(interp, turn.points[0]) ||
	    !go_round(interp, &turn, across + (turn.count > 1 ? next_across + comp->idle_across : 0), move))
		return false;
	comp->idle_across = 0;
	spread_in_plane(interp, move, turn.spread_after);
	move->spread[comp_slot_across(interp)] += turn.count > 1 || turn.spread > 0 ? next_across : 0;
	cover_frame(interp, move);
	return true;
}

/* The current block waits from now on. */
static void wait_for_next(struct interp *interp, const struct comp_way *way, struct plane_point ahead, double across)
{
	struct cutter_comp *comp = &interp->comp;

	comp->waiting = *way;
	comp->ahead = ahead;
	comp->across = across;
	comp->idle_blocks = 0;
	comp->idle_across = 0;
	comp->moved = true;
}

/* ------------------------------------------------------------------ moves */

void comp_lookahead_begin(struct cutter_comp *comp, int side, double radius)
{
	comp->looks_ahead = true;
	comp->side = side;
	comp->radius = radius;
	comp->entered = comp->starting = comp->leaving = comp->moved = false;
	comp->idle_blocks = 0;
	comp->idle_across = 0;
}

/* The first block: its end is determined by the next block. */
static bool start(struct interp *interp, const slot_values *target, struct canon_move *move)
{
	struct plane_point from = comp_here(interp), to = comp_point_of(interp, target);
	double across = way_across(interp, target);

	interp->comp.queue.start = from;
	interp->comp.starting = true;
	if (!comp_add_line(interp, target, move, (struct plane_point){0, 0}, to))
		return false;
	wait_for_next(interp, &(struct comp_way){.point = from, .direction = direction_of(from, to)},
		      direction_of(from, to), across);
	return true;
}

/* The block of G40: straight from the point beside the end of the last block to its own programmed end. */
static bool leave(struct interp *interp, const slot_values *target, struct canon_move *move)
{
	struct cutter_comp *comp = &interp->comp;
	struct plane_point from = comp_here(interp), to = comp_point_of(interp, target);
	struct comp_way after = {.point = from, .direction = direction_of(from, to)};

	if (comp->starting)
		return fault(&interp->at, column_of(interp),
			     "G40 in the block directly after the start of cutter compensation is not supported");
	if (!pass_corner(interp, &after, way_across(interp, target), move) ||
	    !comp_add_line(interp, target, move, (struct plane_point){0, 0}, to) || !comp_send_all(interp, to))
		return false;
	comp->side = 0;
	comp->entered = comp->leaving = false;
	return true;
}

bool comp_lookahead_line(struct interp *interp, const slot_values *target, struct canon_move *move)
{
	struct cutter_comp *comp = &interp->comp;
	struct plane_point from = comp_here(interp), to = comp_point_of(interp, target), ahead, aside;
	struct comp_way way = {.point = from};
	double across = way_across(interp, target);

	/* A shorter move has no direction. */
	if (distance(from, to) < SAME_POINT) {
		comp->idle_across += across;
		return comp->entered ? comp_add_line(interp, target, move, (struct plane_point){0, 0}, comp->current)
				     : motion_commands_go(interp, target, move);
	}
	if (!check_axes(interp, target))
		return false;
	if (comp->leaving)
		return leave(interp, target, move);
	if (!comp->entered)
		return start(interp, target, move);
	ahead = way.direction = direction_of(from, to);
	if (!pass_corner(interp, &way, across, move))
		return false;
	aside = (struct plane_point){to.a - comp->side * comp->radius * ahead.b,
				     to.b + comp->side * comp->radius * ahead.a};
	comp->starting = false;
	if (!comp_add_line(interp, target, move, ahead, aside))
		return false;
	wait_for_next(interp, &way, ahead, across);
	return true;
}

bool comp_lookahead_arc(struct interp *interp, const slot_values *target, struct plane_point centre, int turns,
			struct canon_move *move)
{
	struct cutter_comp *comp = &interp->comp;
	struct plane_point from = comp_here(interp), to = comp_point_of(interp, target), ahead;
	bool clockwise = interp->block.motion == G2, inside = (comp->side > 0) != clockwise;
	double radius = distance(to, centre), across = way_across(interp, target);
	struct comp_item item = {.centre = centre, .clockwise = clockwise, .turns = turns};
	struct comp_way way = {
	    .is_arc = true, .point = from, .centre = centre, .clockwise = clockwise, .inside = inside};

	if (!comp->entered || comp->leaving)
		return fault(&interp->at, column_of(interp),
			     "cutter compensation must start and end with G0 or G1, not with an arc");
	if (!check_axes(interp, target))
		return false;
	if (inside && fmin(radius, distance(from, centre)) <= comp->radius)
		return fault(&interp->at, column_of(interp),
			     "the radius of the arc, %.6g mm, is not greater than the compensation radius, %.6g mm",
			     radius, comp->radius);
	ahead = tangent(centre, to, clockwise);
	way.direction = tangent(centre, from, clockwise);
	way.radius = radius + (inside ? -comp->radius : comp->radius);
	if (!pass_corner(interp, &way, across, move))
		return false;
	comp->starting = false;
	item.end = (struct plane_point){to.a - comp->side * comp->radius * ahead.b,
					to.b + comp->side * comp->radius * ahead.a};
	item.programmed_sweep = fabs(arc_sweep(from, to, centre, clockwise, turns, SAME_POINT / radius));
	if (!comp_add_arc(interp, target, move, &item))
		return false;
	comp_arrive(interp, target, item.end);
	wait_for_next(interp, &way, ahead, across);
	return true;
}

/* ------------------------------------------------------------------ G40 */

bool comp_lookahead_leaves(const struct interp *interp)
{
	const struct block *block = &interp->block;
	char a = AXIS_LETTERS[comp_slot_a(interp)], b = AXIS_LETTERS[comp_slot_b(interp)];

	return block->g[G_NONMODAL] == CODE_NONE && block->motion >= G0 && block->motion <= G3 &&
	       (block_has(block, a) || block_has(block, b));
}

/*
 * The tool is beside the end of the last block, and any next move takes it to the programmed point. The path to that
 * point is proved now, and until both axes have been commanded their positions are uncertain by this distance.
 */
bool comp_lookahead_stop(struct interp *interp)
{
	struct cutter_comp *comp = &interp->comp;
	slot_values here = rotated_frame_straight(&interp->state);
	struct canon_move move;
	struct comp_item item;

	if (comp->starting)
		return fault(&interp->at, column_of(interp),
			     "G40 directly after the first block of cutter compensation is not supported");
	move = (struct canon_move){.kind = CANON_RAPID};
	if (comp->queue.count > 0)
		move =
		    (struct canon_move){.kind = comp->queue.items[0].move.kind, .feed = comp->queue.items[0].move.feed};
	if (move.kind == CANON_ARC)
		move.kind = CANON_FEED;
	if (!comp_send_to(interp, comp->current))
		return false;
	spread_in_plane(interp, &move, comp->radius);
	cover_frame(interp, &move);
	item = (struct comp_item){
	    .kind = COMP_LINE, .end = comp_here(interp), .move = comp_complete(interp, &move, &here)};
	if (!motion_commands_enqueue(interp, &item) || !comp_send_all(interp, item.end))
		return false;
	comp->loose[comp_slot_a(interp)] = comp->loose[comp_slot_b(interp)] = comp->radius;
	return true;
}
