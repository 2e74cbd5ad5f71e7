#include "motion/path.h"

#include "base/math/math_functions.h"
#include "base/minmax.h"
#include "geom/tolerance.h"

#include <float.h>
#include <math.h>

/* An arc in its plane: foot + rise u normal + (r0 + growth u) (cos(sweep u) e1 + sin(sweep u) e2). */
struct turn {
	vec3 foot, e1, e2, normal;
	double r0, growth, rise, sweep;
};

static vec3 linear_part(const axis_values *q)
{
	return (vec3){q->v[SLOT_X], q->v[SLOT_Y], q->v[SLOT_Z]};
}

static void set_linear_part(axis_values *q, vec3 p)
{
	q->v[SLOT_X] = p.x;
	q->v[SLOT_Y] = p.y;
	q->v[SLOT_Z] = p.z;
}

static vec3 across(vec3 a, vec3 unit)
{
	return vec3_mad(a, -vec3_dot(a, unit), unit);
}

static struct turn turn_of(const struct path *path)
{
	const struct canon_arc *arc = &path->arc;
	vec3 start = linear_part(&path->start), end = linear_part(&path->end);
	vec3 from = across(vec3_sub(start, arc->centre), arc->normal);
	vec3 to = across(vec3_sub(end, arc->centre), arc->normal);
	double r0 = vec3_norm(from), r1 = vec3_norm(to);
	struct turn turn = {.foot = vec3_sub(start, from), .normal = arc->normal, .r0 = r0, .growth = r1 - r0,
			    .rise = vec3_dot(vec3_sub(end, start), arc->normal), .sweep = arc->sweep};

	if (r0 > 0) {
		turn.e1 = vec3_scale(1 / r0, from);
	} else if (r1 > 0) {
		/* A spiral that starts at its centre: only its end has a direction. */
		mat3 back = mat3_turn(arc->normal, -arc->sweep);

		turn.e1 = vec3_scale(1 / r1, mat3_apply(&back, to));
	}
	turn.e2 = vec3_cross(arc->normal, turn.e1);
	return turn;
}

static double turn_radius(const struct turn *turn, double u)
{
	return turn->r0 + turn->growth * u;
}

static vec3 turn_position(const struct turn *turn, double u)
{
	double radius = turn_radius(turn, u), c, s;
	vec3 axis = vec3_mad(turn->foot, turn->rise * u, turn->normal);

	math_sin_cos(turn->sweep * u, &s, &c);
	return vec3_mad(vec3_mad(axis, radius * c, turn->e1), radius * s, turn->e2);
}

static vec3 turn_velocity(const struct turn *turn, double u)
{
	double radius = turn_radius(turn, u), c, s;
	vec3 out = vec3_scale(turn->rise, turn->normal);

	math_sin_cos(turn->sweep * u, &s, &c);
	out = vec3_mad(out, turn->growth * c - turn->sweep * radius * s, turn->e1);
	return vec3_mad(out, turn->growth * s + turn->sweep * radius * c, turn->e2);
}

/* The length of the second derivative, which lies in the plane: inwards sweep^2 r, along 2 sweep growth. */
static double turn_second_derivative(const struct turn *turn, double u0, double u1)
{
	double radius = fmax(turn_radius(turn, u0), turn_radius(turn, u1));
	double inwards = turn->sweep * turn->sweep * radius, along = 2 * turn->sweep * turn->growth;

	return sqrt(inwards * inwards + along * along);
}

static axis_values controller_position(const struct path *path, double u)
{
	axis_values at;

	/* The ends are exact, so that neighbouring paths meet in the same bits. */
	if (u <= 0)
		return path->start;
	if (u >= 1)
		return path->end;
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		at.v[slot] = path->start.v[slot] + u * (path->end.v[slot] - path->start.v[slot]);
	if (path->circular) {
		struct turn turn = turn_of(path);

		set_linear_part(&at, turn_position(&turn, u));
	}
	return at;
}

axis_values path_position(const struct path *path, double u)
{
	axis_values at = controller_position(path, u);

	return path->kind == PATH_TCP ? tcp_to_machine(path->tcp, &at) : at;
}

/* The largest components along X, Y and Z of a unit vector perpendicular to `unit`. */
static vec3 shares(vec3 unit)
{
	return (vec3){math_hypot(unit.y, unit.z), math_hypot(unit.z, unit.x), math_hypot(unit.x, unit.y)};
}

static axis_values arc_bend(const struct path *path, double u0, double u1)
{
	struct turn turn = turn_of(path);
	axis_values second_derivative = {{0}};

	set_linear_part(&second_derivative, vec3_scale(turn_second_derivative(&turn, u0, u1), shares(turn.normal)));
	return second_derivative;
}

/*
 * The largest factor by which the matrix stretches a unit vector in the plane of e1 and e2: the larger singular value.
 */
static double stretch(const mat3 *matrix, vec3 e1, vec3 e2)
{
	vec3 a = mat3_apply(matrix, e1), b = mat3_apply(matrix, e2);
	double mean = (vec3_norm2(a) + vec3_norm2(b)) / 2, half = (vec3_norm2(a) - vec3_norm2(b)) / 2;

	return sqrt(mean + math_hypot(half, vec3_dot(a, b)));
}

static axis_values guided_second_derivative(const struct path *path, double u0, double u1)
{
	double u = 0.5 * (u0 + u1), acceleration = 0;
	axis_values middle = controller_position(path, u), rate;

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		rate.v[slot] = path->end.v[slot] - path->start.v[slot];
	if (path->circular) {
		struct turn turn = turn_of(path);

		set_linear_part(&rate, turn_velocity(&turn, u));
		acceleration = turn_second_derivative(&turn, u0, u1) * stretch(&path->tcp->matrix, turn.e1, turn.e2);
	}
	return tcp_bend(path->tcp, &middle, &rate, acceleration, 0.5 * (u1 - u0));
}

axis_values path_second_derivative(const struct path *path, double u0, double u1)
{
	switch (path->kind) {
	case PATH_ARC:
		return arc_bend(path, u0, u1);
	case PATH_TCP:
		return guided_second_derivative(path, u0, u1);
	case PATH_STRAIGHT:
	case PATH_BOX:
		break;
	}
	return (axis_values){{0}};
}

/* The largest value of each axis along the path, and the rounding of the arc. */
static axis_values reach_of(const struct path *path, double *arc_rounding)
{
	axis_values reach;
	double radius;

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		reach.v[slot] = larger(fabs(path->start.v[slot]), fabs(path->end.v[slot]));
	*arc_rounding = 0;
	if (!path->circular)
		return reach;
	radius = fmax(vec3_norm(vec3_sub(linear_part(&path->start), path->arc.centre)),
		      vec3_norm(vec3_sub(linear_part(&path->end), path->arc.centre)));
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		reach.v[slot] += 2 * radius;
	*arc_rounding = POSITION_ROUNDING * (vec3_norm(path->arc.centre) + radius * (2 + fabs(path->arc.sweep)));
	return reach;
}

/* The distance between the end of the arc's formula and the end that the interpreter gave: normally rounding only. */
static double arc_miss(const struct path *path)
{
	struct turn turn = turn_of(path);

	return vec3_norm(vec3_sub(turn_position(&turn, 1), linear_part(&path->end)));
}

static axis_values arc_chord_error(const struct path *path, double u0, double u1)
{
	struct turn turn = turn_of(path);
	axis_values chord_error = {{0}};
	double h = u1 - u0, rounding, radius = fmax(turn_radius(&turn, u0), turn_radius(&turn, u1));
	/* However long the arc, arc and chord are both within the circle. */
	double bound = fmin(h * h / 8 * turn_second_derivative(&turn, u0, u1), 2 * radius) * BOUND_SLACK;
	vec3 share = shares(turn.normal);

	reach_of(path, &rounding);
	if (u1 >= 1)
		rounding += arc_miss(path);
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		chord_error.v[slot] = rounding;
	set_linear_part(&chord_error, vec3_mad(linear_part(&chord_error), bound, share));
	return chord_error;
}

static axis_values guided_chord_error(const struct path *path, double u0, double u1)
{
	double h = u1 - u0, arc_rounding;
	axis_values reach = reach_of(path, &arc_rounding);
	axis_values rounding = tcp_rounding(path->tcp, &reach);
	axis_values chord_error = guided_second_derivative(path, u0, u1);

	if (path->circular && u1 >= 1)
		arc_rounding += arc_miss(path);
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		/* An error of the arc is multiplied by M (norm at most sqrt(3)) and by a row of its inverse. */
		rounding.v[slot] += 2 * arc_rounding * path->tcp->row_norms[slot];
		chord_error.v[slot] = h * h / 8 * chord_error.v[slot] * BOUND_SLACK + rounding.v[slot];
	}
	return chord_error;
}

axis_values path_chord_error(const struct path *path, double u0, double u1)
{
	switch (path->kind) {
	case PATH_ARC:
		return arc_chord_error(path, u0, u1);
	case PATH_TCP:
		return guided_chord_error(path, u0, u1);
	case PATH_STRAIGHT:
	case PATH_BOX:
		break;
	}
	return (axis_values){{0}};
}

double path_length(const struct path *path)
{
	struct turn turn;
	vec3 way = vec3_sub(linear_part(&path->end), linear_part(&path->start));

	if (!path->circular)
		return vec3_norm(way);
	turn = turn_of(path);
	/* Simpson's rule: exact for a helix; the radii of a spiral differ by at most the controller's tolerance. */
	return (vec3_norm(turn_velocity(&turn, 0)) + 4 * vec3_norm(turn_velocity(&turn, 0.5)) +
		vec3_norm(turn_velocity(&turn, 1))) / 6;
}
