#include "gcode/execute/corner_insert.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/math/math_functions.h"
#include "base/math/math_functions.h"
#include "base/mem.h"
#include "base/units.h"
#include "gcode/execute/cutter_comp/comp_moves.h"
#include "gcode/execute/cutter_comp/comp_turn.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/rotated_frame.h"
#include "geom/tolerance.h"

/* Radians: a flatter corner, or one that is as near to a reversal, has no well-defined rounding. */
#define FLAT_CORNER 0.0175

static double distance(struct plane_point p, struct plane_point q)
{
	return math_hypot(p.a - q.a, p.b - q.b);
}

/* The names of the corner's words in messages. */
static const char *names(const struct interp *interp)
{
	const char *given = traits_of(interp)->corner_names;

	return given ? given : ",C or ,R";
}

/* After a fault: the corner is dropped, so that it causes no further faults. */
static bool drop(struct interp *interp)
{
	interp->corner.on = false;
	free(interp->corner.text);
	interp->corner.text = NULL;
	return false;
}

bool corner_insert_start_block(struct interp *interp)
{
	const struct block *block = &interp->block;
	bool more = block->m_count > 0 || block_has(block, 'S') || block_has(block, 'T');

	for (int group = 0; group < G_GROUPS; group++)
		more = more || (group != G_MOTION && group != G_DISTANCE && block->g[group] != CODE_NONE);
	if (interp->corner.on && more) {
		fault_report(
		    &interp->at, 1,
		    "the block after a chamfer or rounding (%s) must have a move in the plane and no other code",
		    names(interp));
		return drop(interp);
	}
	if (block->corner == '\0')
		return true;
	if (!traits_of(interp)->corner_words)
		return is_answered(interp, block->corner_column, 0, "whether ,C and ,R make a corner");
	if (block->motion < G1 || block->motion > G3 || block->g[G_NONMODAL] != CODE_NONE)
		return fault(&interp->at, block->corner_column, ",%c needs a block with G1, G2 or G3", block->corner);
	if (more && block->m_count > 0)
		return fault(&interp->at, block->corner_column,
			     ",%c beside an M-code is not supported; write two blocks", block->corner);
	if (!(block->corner_value > 0))
		return fault(&interp->at, block->corner_column, ",%c must be greater than 0", block->corner);
	return true;
}

/* Does the move leave the plane, or not move in the plane? */
static bool leaves_plane(const struct interp *interp, const slot_values *target)
{
	slot_values here = rotated_frame_straight(&interp->state);

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		bool in_plane = slot == (int)comp_slot_a(interp) || slot == (int)comp_slot_b(interp);

		if (!in_plane && fabs(target->v[slot] - here.v[slot]) > SAME_COORDINATE)
			return true;
	}
	return distance(comp_here(interp), comp_point_of(interp, target)) < SAME_COORDINATE;
}

static struct plane_point direction_at(const struct comp_way *way, struct plane_point at, struct plane_point to)
{
	struct plane_point radial = {(at.a - way->centre.a) / fmax(distance(at, way->centre), SAME_POINT),
				     (at.b - way->centre.b) / fmax(distance(at, way->centre), SAME_POINT)};
	double length = distance(at, to);

	if (!way->is_arc)
		return (struct plane_point){(to.a - at.a) / length, (to.b - at.b) / length};
	return way->clockwise ? (struct plane_point){radial.b, -radial.a} : (struct plane_point){-radial.b, radial.a};
}

/* The point of a path nearest to the centre of the rounding. */
static struct plane_point touch(const struct comp_way *way, struct plane_point at, struct plane_point direction,
				struct plane_point centre)
{
	struct plane_point from_centre = plane_along(centre, -1, way->centre), from_at = plane_along(centre, -1, at);
	double radius = distance(at, way->centre), length = math_hypot(from_centre.a, from_centre.b);

	if (!way->is_arc)
		return plane_along(at, plane_dot(from_at, direction), direction);
	return plane_along(way->centre, radius / fmax(length, SAME_POINT), from_centre);
}

/* Is the point on the path between two of its points? */
static bool lies_between(const struct comp_way *way, struct plane_point from, struct plane_point to,
			 struct plane_point point)
{
	struct plane_point whole = plane_along(to, -1, from);

	if (!way->is_arc)
		return plane_dot(plane_along(point, -1, from), whole) >= 0 &&
		       plane_dot(plane_along(point, -1, from), whole) <= plane_dot(whole, whole);
	return fabs(arc_sweep(from, point, way->centre, way->clockwise, 1, 0)) <=
	       fabs(arc_sweep(from, to, way->centre, way->clockwise, 1, SAME_POINT));
}

/* The corner between the block that waits and the next one. */
struct insertion {
	struct plane_point first, last; /* its start and end */
	struct plane_point centre; /* of a rounding */
	bool clockwise;
};

static bool find_insertion(struct interp *interp, const struct corner_move *next, struct insertion *insertion)
{
	const struct pending_corner *corner = &interp->corner;
	struct plane_point at = comp_here(interp), to = comp_point_of(interp, next->target);
	struct plane_point from = comp_point_of(interp, &corner->start);
	struct comp_way before = corner->way;
	struct comp_way after = {
	    .is_arc = next->is_arc, .centre = next->centre, .clockwise = interp->block.motion == G2};
	struct plane_point ahead, onward = direction_at(&after, at, to);
	double angle;

	ahead = before.is_arc ? direction_at(&before, at, at) : direction_at(&before, from, at);
	angle = math_atan2(plane_cross(ahead, onward), plane_dot(ahead, onward));
	if (fabs(angle) < FLAT_CORNER || fabs(angle) > PI - FLAT_CORNER)
		return fault(&interp->at, block_motion_column(&interp->block),
			     "the path has no corner at the chamfer or rounding (%s) of line %ld", names(interp),
			     corner->at.line);
	insertion->clockwise = angle < 0;
	if (corner->letter != 'R' && (before.is_arc || after.is_arc))
		return fault(&interp->at, block_motion_column(&interp->block),
			     "a chamfer (%s) beside an arc is not supported", names(interp));
	if (corner->letter != 'R') {
		const double leg = corner->letter == 'L' ? corner->size / (2 * math_cos(angle / 2)) : corner->size;

		insertion->first = plane_along(at, -leg, ahead);
		insertion->last = plane_along(at, leg, onward);
	} else {
		struct comp_corner_shape shape = {.before = &before,
						  .after = &after,
						  .at = at,
						  .ahead = ahead,
						  .onward = onward,
						  .radius = corner->size,
						  .side = angle > 0 ? 1 : -1};

		before.inside = (shape.side > 0) != before.clockwise;
		after.inside = (shape.side > 0) != after.clockwise;
		if (!comp_turn_crossing(&shape, &insertion->centre))
			return fault(&interp->at, block_motion_column(&interp->block),
				     "the rounding (%s) of line %ld does not touch both of its blocks", names(interp),
				     corner->at.line);
		insertion->first = touch(&before, at, ahead, insertion->centre);
		insertion->last = touch(&after, at, onward, insertion->centre);
	}
	if (!lies_between(&before, from, at, insertion->first) || !lies_between(&after, at, to, insertion->last))
		return fault(&interp->at, block_motion_column(&interp->block),
			     "the chamfer or rounding (%s) of line %ld is longer than one of its blocks", names(interp),
			     corner->at.line);
	return true;
}

static bool go(struct interp *interp, struct plane_point to, bool is_arc, struct plane_point centre)
{
	slot_values here = rotated_frame_straight(&interp->state), target = here;
	struct plane_point from = comp_here(interp);
	struct canon_move move = {.kind = is_arc ? CANON_ARC : CANON_FEED, .feed = interp->corner.move.feed};
	double normal[3] = {0}, xyz[3] = {here.v[SLOT_X], here.v[SLOT_Y], here.v[SLOT_Z]};

	target.v[comp_slot_a(interp)] = to.a;
	target.v[comp_slot_b(interp)] = to.b;
	if (cutter_comp_is_on(interp))
		return is_arc ? cutter_comp_arc(interp, &target, centre, 1, &move)
			      : cutter_comp_line(interp, &target, &move);
	if (is_arc) {
		xyz[comp_slot_a(interp)] = centre.a;
		xyz[comp_slot_b(interp)] = centre.b;
		normal[comp_slot_across(interp)] = 1;
		move.arc.centre = rotated_frame_point(&interp->state, (vec3){xyz[0], xyz[1], xyz[2]});
		move.arc.normal = rotated_frame_normal(&interp->state, (vec3){normal[0], normal[1], normal[2]});
		move.arc.sweep = arc_sweep(from, to, centre, interp->block.motion == G2, 1, 0);
	}
	return motion_commands_go(interp, &target, &move);
}

static void put_at(struct interp *interp, const slot_values *straight)
{
	slot_values position = rotated_frame_position(&interp->state, straight);

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		state_set_position(&interp->state, slot, position.v[slot]);
}

/* Makes the moves of the waiting block and of its corner, and sends the end of the block. */
static bool make_waiting(struct interp *interp, const struct insertion *insertion)
{
	struct pending_corner corner = interp->corner;
	const struct block block = interp->block;
	const struct line_place at = interp->at;
	const struct call_chain callers = interp->callers;
	int moves = interp->moves;
	bool good;

	interp->block = corner.block;
	interp->at = corner.at;
	interp->callers = corner.callers;
	interp->moves = 0;
	put_at(interp, &corner.start);
	good = go(interp, insertion->first, corner.way.is_arc, corner.way.centre);
	interp->block.motion = corner.letter != 'R' ? G1 : insertion->clockwise ? G2 : G3;
	good = good && go(interp, insertion->last, corner.letter == 'R', insertion->centre);
	interp->corner.on = false;
	good = good && cutter_comp_end_block(interp);
	interp->block = block;
	interp->at = at;
	interp->callers = callers;
	interp->moves = moves;
	free(interp->corner.text);
	interp->corner.text = NULL;
	return good;
}

bool corner_insert_pass(struct interp *interp, const struct corner_move *next, bool *waits)
{
	const struct block *block = &interp->block;
	struct pending_corner *corner = &interp->corner;
	struct insertion insertion = {.clockwise = false};
	bool arcs = traits_of(interp)->corner_words == CORNER_WORDS_WITH_ARCS;

	*waits = false;
	if (leaves_plane(interp, next->target) || block->motion < G1)
		return fault(&interp->at, block_motion_column(block),
			     "the blocks before and after a chamfer or rounding (%s) must be moves with G1, G2 or G3 "
			     "in the plane only",
			     names(interp));
	if (next->is_arc && !arcs)
		return fault(&interp->at, block_motion_column(block),
			     "this control does not support a chamfer or rounding (%s) beside an arc", names(interp));
	if (corner->on && (!find_insertion(interp, next, &insertion) || !make_waiting(interp, &insertion)))
		return drop(interp);
	if (block->corner == '\0')
		return true;
	*corner = (struct pending_corner){
	    .on = true,
	    .letter = block->corner,
	    .size = block->corner_value * interp->state.scale,
	    .block = *block,
	    .at = interp->at,
	    .callers = interp->callers,
	    .move = *next->move,
	    .start = rotated_frame_straight(&interp->state),
	    .way = {.is_arc = next->is_arc, .centre = next->centre, .clockwise = block->motion == G2},
	    .text = mem_strndup(interp->at.text, strlen(interp->at.text))};
	corner->at.text = corner->text;
	corner->fresh = true;
	put_at(interp, next->target);
	*waits = true;
	return true;
}

bool corner_insert_keeps_block(struct interp *interp)
{
	return interp->corner.on && interp->corner.fresh;
}

bool corner_insert_end_block(struct interp *interp)
{
	struct pending_corner *corner = &interp->corner;

	if (!corner->on)
		return true;
	if (corner->fresh) {
		corner->fresh = false;
		return true;
	}
	fault_report(&interp->at, 1,
		     "the block after a chamfer or rounding (%s) must be a move with G1, G2 or G3 in the plane",
		     names(interp));
	return drop(interp);
}
