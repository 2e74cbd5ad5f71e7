#include "gcode/execute/cutter_comp/comp_turn.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/units.h"
#include "gcode/execute/cutter_comp/comp_moves.h"
#include "geom/tolerance.h"

/* Radians: at a reversal of the path within this tolerance, the outside of the corner is not certain. */
#define REVERSAL 0.0175

/* Radians: at a sharper corner the intersection of the compensated paths is farther away than three radii. */
#define SHARPEST 2.4

/* Radians: below this angle arcs count as tangent to their neighbour, and need not intersect it. */
#define MEANT_TANGENT 0.01

/* The greatest distance of an arc about a corner from the extended path, as a share of the radius. */
#define ROUND_BESIDE_DRAWN 0.42

/* mm: a flatter outside corner needs no extra moves. */
#define FLAT 1e-3

static double distance(struct plane_point p, struct plane_point q)
{
	return math_hypot(p.a - q.a, p.b - q.b);
}

static struct plane_point foot_of(const struct comp_corner_shape *c, struct plane_point direction)
{
	return plane_along(c->at, c->radius * c->side, (struct plane_point){-direction.b, direction.a});
}

static void add(struct comp_turn *turn, struct plane_point point)
{
	turn->points[turn->count++] = point;
}

/* The intersection of the two compensated lines. */
static struct plane_point line_crossing(const struct comp_corner_shape *c)
{
	struct plane_point sum = {c->foot.a + c->next_foot.a - 2 * c->at.a, c->foot.b + c->next_foot.b - 2 * c->at.b};

	return plane_along(c->at, 1 / (1 + plane_dot(c->ahead, c->onward)), sum);
}

/* Adds the points of extended lines around an outside corner: one, or two if the corner is acute. */
static void add_drawn(struct comp_turn *turn, const struct comp_corner_shape *c)
{
	if (c->angle <= PI / 2) {
		add(turn, line_crossing(c));
		return;
	}
	add(turn, plane_along(c->foot, c->radius, c->ahead));
	add(turn, plane_along(c->next_foot, -c->radius, c->onward));
}

/* ------------------------------------------------------- inside corners */

/* Keeps the intersection that is nearer to the two feet. */
static void consider(const struct comp_corner_shape *c, struct plane_point crossing, double *nearest,
		     struct plane_point *found)
{
	struct plane_point middle = {(c->foot.a + c->next_foot.a) / 2, (c->foot.b + c->next_foot.b) / 2};
	double far = distance(crossing, middle);

	if (far < *nearest) {
		*nearest = far;
		*found = crossing;
	}
}

/* The radius of the compensated arc at the corner. */
static double tool_radius(const struct comp_corner_shape *c, const struct comp_way *way)
{
	return distance(c->at, way->centre) + (way->inside ? -c->radius : c->radius);
}

static bool cross_line(const struct comp_corner_shape *c, struct plane_point foot, struct plane_point direction,
		       const struct comp_way *arc, struct plane_point *found)
{
	struct plane_point to_centre = plane_along(arc->centre, -1, foot);
	double height = plane_cross(direction, to_centre), radius = tool_radius(c, arc), half, nearest = INFINITY;

	half = radius * radius - height * height;
	if (half < 0)
		return false;
	for (int sign = -1; sign <= 1; sign += 2)
		consider(c, plane_along(foot, plane_dot(to_centre, direction) + sign * sqrt(half), direction), &nearest,
			 found);
	return true;
}

static bool cross_arcs(const struct comp_corner_shape *c, struct plane_point *found)
{
	struct plane_point between = plane_along(c->after->centre, -1, c->before->centre);
	double apart = math_hypot(between.a, between.b), r0 = tool_radius(c, c->before), r1 = tool_radius(c, c->after);
	double foot, half, nearest = INFINITY;

	if (!(apart > 0))
		return false;
	foot = (r0 * r0 - r1 * r1 + apart * apart) / (2 * apart);
	half = r0 * r0 - foot * foot;
	if (half < 0)
		return false;
	for (int sign = -1; sign <= 1; sign += 2) {
		struct plane_point on_line = plane_along(c->before->centre, foot / apart, between);

		consider(c,
			 plane_along(on_line, sign * sqrt(half) / apart, (struct plane_point){-between.b, between.a}),
			 &nearest, found);
	}
	return true;
}

static bool find_crossing(const struct comp_corner_shape *c, struct plane_point *found)
{
	if (c->before->is_arc && c->after->is_arc)
		return cross_arcs(c, found);
	if (c->before->is_arc)
		return cross_line(c, c->next_foot, c->onward, c->before, found);
	if (c->after->is_arc)
		return cross_line(c, c->foot, c->ahead, c->after, found);
	*found = line_crossing(c);
	return true;
}

bool comp_turn_crossing(const struct comp_corner_shape *shape, struct plane_point *found)
{
	struct comp_corner_shape c = *shape;

	c.foot = foot_of(&c, c.ahead);
	c.next_foot = foot_of(&c, c.onward);
	return find_crossing(&c, found);
}

static bool turn_inside(struct interp *interp, const struct comp_corner_shape *c, struct comp_turn *turn)
{
	struct plane_point crossing = c->foot;

	if (find_crossing(c, &crossing)) {
		add(turn, crossing);
		return true;
	}
	if (fabs(c->angle) > MEANT_TANGENT)
		return fault(&interp->at, block_motion_column(&interp->block),
			     "an inside corner is too narrow for the tool (radius %.6g mm), which would gouge",
			     c->radius);
	/* The control ends the block before at an unknown point between the two feet. */
	add(turn, c->foot);
	turn->spread_before = turn->spread_after = distance(c->foot, c->next_foot);
	return true;
}

/* ------------------------------------------------------ outside corners */

/* The path may be extended to the intersection, be a circle, or be between these: all of this is proved. */
static void turn_between(const struct comp_corner_shape *c, struct comp_turn *turn)
{
	const bool by_arcs = c->before->is_arc || c->after->is_arc;
	const double beside = c->radius * (1 / math_cos(c->angle / 2) - 1);

	if (beside < FLAT && !by_arcs) {
		add(turn, line_crossing(c));
		turn->spread_before = turn->spread_after = beside;
		return;
	}
	add(turn, c->foot);
	add(turn, line_crossing(c));
	add(turn, c->next_foot);
	/* An arc may be extended as an arc; can_cross limits its distance from the tangent to this. */
	turn->spread = beside + (by_arcs ? 2 * distance(c->foot, c->next_foot) * math_sin(fmin(c->angle, PI / 2)) : 0);
}

/* False, reported: the intersection of the paths is too far away, or not known. */
static bool can_cross(struct interp *interp, const struct comp_corner_shape *c)
{
	if (c->angle <= MEANT_TANGENT || (c->angle <= SHARPEST && !(c->before->is_arc && c->before->inside) &&
			      !(c->after->is_arc && c->after->inside)))
		return true;
	return fault(&interp->at, block_motion_column(&interp->block),
		     "the path turns by %.4g degrees at an outside corner%s, and a parameter of the control decides "
		     "whether the corner is extended or rounded: write G450 with DISC=0 to round it; if no G450 or "
		     "G451 comes before, you can also set cutter_comp_corner=\"circular\" in the machine file's "
		     "<controller>",
		     degrees(c->angle), c->angle > SHARPEST ? "" : " beside an arc with the tool on its inside");
}

static void turn_outside(const struct comp_corner_shape *c, enum comp_corner_form form, struct comp_turn *turn)
{
	double half = fmin(c->angle, PI / 2) / 2;
	double beside = c->angle <= PI / 2 ? c->radius * (1 / math_cos(half) - 1) : ROUND_BESIDE_DRAWN * c->radius;

	if (form == COMP_CORNER_BETWEEN || (form == COMP_CORNER_CROSSING_IF_BLUNT &&
					    (c->angle > PI / 2 || c->before->is_arc || c->after->is_arc))) {
		turn_between(c, turn);
		return;
	}
	/* This corner comes only from rounding: an arc between two equal points would be a full turn. */
	if (form == COMP_CORNER_CIRCULAR && c->angle * c->radius <= 2 * SAME_POINT) {
		add(turn, c->foot);
		turn->spread_before = turn->spread_after = distance(c->foot, c->next_foot);
		return;
	}
	if (form == COMP_CORNER_CIRCULAR) {
		add(turn, c->foot);
		add(turn, c->next_foot);
		turn->on_arc = true;
		return;
	}
	/* The form is not known: the spread covers both, and a nearly straight corner needs no extra moves. */
	if (form == COMP_CORNER_UNKNOWN && beside < FLAT && !c->before->is_arc && !c->after->is_arc) {
		add_drawn(turn, c);
		turn->spread_before = turn->spread_after = beside;
		return;
	}
	if (c->before->is_arc || form == COMP_CORNER_UNKNOWN)
		add(turn, c->foot);
	add_drawn(turn, c);
	if (c->after->is_arc || form == COMP_CORNER_UNKNOWN)
		add(turn, c->next_foot);
	turn->spread = form == COMP_CORNER_UNKNOWN ? beside : 0;
}

/* ------------------------------------------------------ the way in and out */

/* The greatest distance from `from` to the points that the tool may reach; every path is between these points. */
static double farthest(const struct comp_corner_shape *c, const struct comp_turn *drawn, struct plane_point from)
{
	double far = fmax(distance(from, c->foot), distance(from, c->next_foot));

	for (int i = 0; i < drawn->count; i++)
		far = fmax(far, distance(from, drawn->points[i]));
	return far;
}

/*
 * The path to the point beside the start of the next block, or from the point beside the end of the last block: type A
 * and inside corners have a straight path, type B moves around an outside corner.
 */
static void turn_at_end(const struct comp_corner_shape *c, enum comp_start type, enum comp_corner_form form,
			bool starting, struct comp_turn *turn)
{
	struct comp_turn drawn = {.count = 0};

	if (c->angle > 0 && (form == COMP_CORNER_BETWEEN || form == COMP_CORNER_CROSSING_IF_BLUNT))
		add(&drawn, line_crossing(c));
	else if (c->angle > 0)
		add_drawn(&drawn, c);
	if (type == COMP_START_A || (type == COMP_START_B && !(c->angle > 0))) {
		add(turn, starting ? c->next_foot : c->foot);
	} else if (type == COMP_START_B && form == COMP_CORNER_CIRCULAR) {
		turn_outside(c, form, turn);
	} else if (type == COMP_START_B && form == COMP_CORNER_LINEAR) {
		if (!starting && c->before->is_arc)
			add(turn, c->foot);
		for (int i = 0; i < drawn.count; i++)
			add(turn, drawn.points[i]);
		if (starting && c->after->is_arc)
			add(turn, c->next_foot);
	} else {
		if (!starting || !(c->angle > 0))
			add(turn, c->foot);
		for (int i = 0; i < drawn.count; i++)
			add(turn, drawn.points[i]);
		if (starting || !(c->angle > 0))
			add(turn, c->next_foot);
		turn->spread = farthest(c, &drawn, turn->points[starting ? 0 : turn->count - 1]);
		/* The path continues straight. */
		if (turn->spread < SAME_POINT)
			turn->count = 1;
		turn->spread_before = starting ? turn->spread : 0;
		turn->spread_after = starting ? 0 : turn->spread;
	}
}

bool comp_turn_find(struct interp *interp, const struct comp_way *after, struct comp_turn *turn)
{
	const struct cutter_comp *comp = &interp->comp;
	struct comp_corner_shape c = {.before = &comp->waiting,
				      .after = after,
				      .at = comp_here(interp),
				      .ahead = comp->ahead,
				      .onward = after->direction,
				      .radius = comp->radius,
				      .side = comp->side};

	c.foot = foot_of(&c, c.ahead);
	c.next_foot = foot_of(&c, c.onward);
	c.angle = c.side * math_atan2(plane_cross(c.onward, c.ahead), plane_dot(c.onward, c.ahead));
	*turn = (struct comp_turn){.corner = c.at};
	if (fabs(c.angle) > PI - REVERSAL)
		return fault(
		    &interp->at, block_motion_column(&interp->block),
		    "the path turns back on itself under cutter compensation: controls differ in which side of the "
		    "corner is the inside");
	if ((comp->corner_form == COMP_CORNER_BETWEEN || comp->corner_form == COMP_CORNER_CROSSING_IF_BLUNT) &&
	    !((comp->starting || comp->leaving) && comp->start_type == COMP_START_A) && !can_cross(interp, &c))
		return false;
	if (comp->starting || comp->leaving) {
		turn_at_end(&c, comp->start_type, comp->corner_form, comp->starting, turn);
		return true;
	}
	if (c.angle <= 0 || comp->corner_form == COMP_CORNER_CROSSING)
		return turn_inside(interp, &c, turn);
	turn_outside(&c, comp->corner_form, turn);
	return true;
}
