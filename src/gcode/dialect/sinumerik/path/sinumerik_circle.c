#include "gcode/dialect/sinumerik/path/sinumerik_circle.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/same_double.h"
#include "base/units.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/dialect/sinumerik/path/sinumerik_polar.h"
#include "gcode/dialect/sinumerik/path/sinumerik_target.h"
#include "gcode/execute/arc.h"
#include "geom/tolerance.h"

/* The points of CIP are on one line if the sine of the angle between the two chords is less than this. */
#define LEAST_BEND 1e-9
/* The maximum number of full turns of a helix (840D sl, TURN). */
#define TURNS_MAX 999
/* Radians: a smaller angle is a full turn. */
#define SAME_ANGLE 1e-12

/* CT: the arc is a straight line if the sine of the angle between direction and chord is less than this. */
#define LEAST_TURN 1e-8

struct circle_plane {
	enum axis_slot a, b, across;
	char centre_a, centre_b, not_used;
	vec3 normal;
};

static const struct circle_plane *plane_of(int code)
{
	static const struct circle_plane planes[] = {{SLOT_X, SLOT_Y, SLOT_Z, 'I', 'J', 'K', {0, 0, 1}},
						     {SLOT_Z, SLOT_X, SLOT_Y, 'K', 'I', 'J', {0, 1, 0}},
						     {SLOT_Y, SLOT_Z, SLOT_X, 'J', 'K', 'I', {1, 0, 0}}};

	return &planes[code == G17 ? 0 : code == G18 ? 1 : 2];
}

static const struct arc_tolerance *tolerance_of(const struct interp *interp)
{
	return interp->state.scale > 1 ? &arc_tolerance_inch : &arc_tolerance_mm;
}

static int circle_column(const struct sinumerik_block *block)
{
	return block->code[SINUMERIK_MOTION] != CODE_NONE ? block->code_column[SINUMERIK_MOTION]
							  : sinumerik_block_axis_column(block);
}

/*
 * Converts an arc in program coordinates to one of positions: frames may rotate, mirror and scale it. NULL: it is in
 * no plane.
 */
static bool place_arc(struct interp *interp, const struct sinumerik_block *block, const struct circle_plane *plane,
		      vec3 centre, vec3 normal, double sweep, struct canon_arc *arc)
{
	const struct state *state = &interp->state;
	const vec3 offset = slot_values_linear(&state->offset);
	const mat3 *turn = &state->frame.turn;
	double scale;
	bool mirrored;

	*arc = (struct canon_arc){.centre = vec3_add(offset, centre), .normal = normal, .sweep = sweep};
	if (!state->frame.on)
		return true;
	if (plane ? !sinumerik_frame_scale_plane(turn, plane->across, &scale) : !sinumerik_frame_scale(turn, &scale))
		return fault(
		    &interp->at, circle_column(block),
		    "a circle where the frame scales the axes of its plane differently is none any more; SCALE both "
		    "alike");
	mirrored = vec3_dot(turn->x, vec3_cross(turn->y, turn->z)) < 0;
	arc->centre = vec3_add(vec3_add(offset, state->frame.origin), mat3_apply(turn, centre));
	arc->normal = vec3_unit(mat3_apply(turn, normal));
	arc->sweep = mirrored ? -sweep : sweep;
	return true;
}

/* --------------------------------------------------------------------- CIP */

static bool through_point(struct interp *interp, const struct sinumerik_block *block, const slot_values *start,
			  const slot_values *end, struct canon_arc *arc)
{
	static const enum sinumerik_address addresses[3] = {SINUMERIK_I1, SINUMERIK_J1, SINUMERIK_K1};
	const vec3 from = slot_values_linear(start);
	double at[3] = {from.x, from.y, from.z}, sweep;
	vec3 u, v, normal, middle, centre;

	for (int i = 0; i < 3; i++) {
		if (sinumerik_block_has_address(block, addresses[i]))
			at[i] = sinumerik_target_centre(interp, block->address_value[addresses[i]],
							(enum sinumerik_way)block->address_way[addresses[i]],
							!interp->state.incremental, at[i]);
	}
	middle = (vec3){at[0], at[1], at[2]};
	u = vec3_sub(middle, from);
	v = vec3_sub(slot_values_linear(end), from);
	normal = vec3_cross(u, v);
	if (!(vec3_norm(normal) > LEAST_BEND * vec3_norm(u) * vec3_norm(v)))
		return fault(&interp->at, circle_column(block),
			     "CIP needs three different points that do not lie on a line: start, I1= J1= K1=, end");
	/* The centre of the circle through start, middle and end. */
	centre = vec3_scale(1 / (2 * vec3_norm2(normal)),
			    vec3_add(vec3_scale(vec3_norm2(u), vec3_cross(v, normal)),
				     vec3_scale(vec3_norm2(v), vec3_cross(normal, u))));
	normal = vec3_unit(normal);
	/* The arc from the start through the middle turns about u x v. */
	sweep = math_atan2(vec3_dot(normal, vec3_cross(vec3_scale(-1, centre), vec3_sub(v, centre))),
		      vec3_dot(vec3_scale(-1, centre), vec3_sub(v, centre)));
	if (sweep < 0)
		sweep += 2 * PI;
	return place_arc(interp, block, NULL, vec3_add(from, centre), normal, sweep, arc);
}

/* --------------------------------------------------------- circles in the plane */

struct circle {
	const struct circle_plane *plane;
	bool clockwise;
	struct plane_point start, end, centre;
	int turns;	/* in the form of arc_sweep */
};

static bool find_turns(struct interp *interp, const struct sinumerik_block *block, int *turns)
{
	const double value = block->address_value[SINUMERIK_TURN];

	*turns = 1;
	if (!sinumerik_block_has_address(block, SINUMERIK_TURN))
		return true;
	if (!(value >= 0 && value <= TURNS_MAX) || floor(value) < value)
		return fault(&interp->at, block->address_column[SINUMERIK_TURN],
			     "TURN must be a whole number from 0 to %d, not %.15g", TURNS_MAX, value);
	*turns = (int)value + 1;
	return true;
}

static bool by_radius(struct interp *interp, const struct sinumerik_block *block, struct circle *c)
{
	const double radius = sinumerik_target_length(interp, block->address_value[SINUMERIK_CR]);
	const int column = block->address_column[SINUMERIK_CR];

	switch (arc_find_centre(c->start, c->end, radius, c->clockwise, tolerance_of(interp), &c->centre)) {
	case ARC_NO_CHORD:
		return fault(
		    &interp->at, column,
		    "a circle by its radius (CR=) cannot end where it starts; a full circle has a centre (I, J, K)");
	case ARC_RADIUS_TOO_SMALL:
		return fault(&interp->at, column,
			     "a radius of %.6g mm does not reach from the start of the circle to its end",
			     fabs(radius));
	default:
		return true;
	}
}

static double centre_word(const struct interp *interp, const struct sinumerik_block *block, char letter, double start)
{
	const int index = letter - 'A';

	/* I, J and K are relative to the start, also with G90 (840D sl, "Circular interpolation"). */
	return sinumerik_block_has(block, letter)
		   ? sinumerik_target_centre(interp, block->value[index], (enum sinumerik_way)block->way[index], false,
					     start)
		   : start;
}

static bool by_centre(struct interp *interp, const struct sinumerik_block *block, struct circle *c)
{
	const int unused = c->plane->not_used - 'A';
	double r0, r1;

	/* An offset of 0 from the start gives no centre. */
	if (sinumerik_block_has(block, c->plane->not_used) &&
	    (fabs(block->value[unused]) > 0 || block->way[unused] == SINUMERIK_WAY_AC))
		return fault(&interp->at, block->column[unused],
			     "%c does not belong to the centre of a circle in the plane of G%d", c->plane->not_used,
			     interp->state.plane / 10);
	c->centre.a = centre_word(interp, block, c->plane->centre_a, c->start.a);
	c->centre.b = centre_word(interp, block, c->plane->centre_b, c->start.b);
	/* "Circular interpolation with polar coordinates": the pole is the centre. */
	if (block->addresses & SINUMERIK_POLAR_BITS)
		c->centre = sinumerik_polar_pole(interp);
	if (sinumerik_block_has_address(block, SINUMERIK_AR))
		return true;
	switch (arc_check_centre(c->start, c->end, c->centre, tolerance_of(interp), &r0, &r1)) {
	case ARC_ZERO_RADIUS:
		return fault(&interp->at, circle_column(block),
			     "a circle of radius 0: %.6g mm at its start, %.6g mm at its end", r0, r1);
	case ARC_RADII_DIFFER:
		return fault(&interp->at, circle_column(block),
			     "the radius of the circle is %.6g mm at its start and %.6g mm at its end", r0, r1);
	default:
		return true;
	}
}

/*
 * "Circular interpolation with tangential transition (CT)": the arc starts in the direction in which the last motion
 * ended. So its centre is beside the start, on the side of the end.
 */
static bool by_tangent(struct interp *interp, const struct sinumerik_block *block, struct circle *c, bool *straight)
{
	const struct sinumerik_tangent *before = &sinumerik_of(interp)->tangent;
	const double length = math_hypot(before->way.a, before->way.b);
	const struct plane_point t = {before->way.a / fmax(length, SAME_POINT),
				      before->way.b / fmax(length, SAME_POINT)};
	const struct plane_point way = {c->end.a - c->start.a, c->end.b - c->start.b};
	const double chord = math_hypot(way.a, way.b), across = t.a * way.b - t.b * way.a;
	double radius;

	if (!before->known || !(length > SAME_POINT) || before->plane != interp->state.plane ||
	    !same_double(before->end.a, c->start.a) || !same_double(before->end.b, c->start.b))
		return fault(&interp->at, circle_column(block),
			     "CT goes on in the direction of the motion before it, which is not known here: move in "
			     "its plane, by G1, G2 or G3, right before it");
	if (!(chord > SAME_POINT))
		return fault(&interp->at, circle_column(block), "CT needs an end that is not its start");
	if (fabs(across) <= LEAST_TURN * chord) {
		*straight = t.a * way.a + t.b * way.b > 0;
		return *straight || fault(&interp->at, circle_column(block), "CT cannot lead straight back");
	}
	radius = chord * chord / (2 * across);
	c->centre = (struct plane_point){c->start.a - radius * t.b, c->start.b + radius * t.a};
	c->clockwise = across < 0;
	return true;
}

/* AR= with the end or with the centre; *sweep is known after it. */
static bool by_angle(struct interp *interp, const struct sinumerik_block *block, bool centred, struct circle *c,
		     double *sweep)
{
	const double degree = block->address_value[SINUMERIK_AR], angle = radians(degree);
	const double chord = math_hypot(c->end.a - c->start.a, c->end.b - c->start.b);
	const double sign = c->clockwise ? -1 : 1;
	const double r_a = c->start.a - c->centre.a, r_b = c->start.b - c->centre.b;

	if (!(degree > 0 && degree < 360))
		return fault(&interp->at, block->address_column[SINUMERIK_AR],
			     "the opening angle AR= must be greater than 0 and less than 360 degrees");
	*sweep = sign * angle;
	if (centred) {
		c->end.a = c->centre.a + math_cos(*sweep) * r_a - math_sin(*sweep) * r_b;
		c->end.b = c->centre.b + math_sin(*sweep) * r_a + math_cos(*sweep) * r_b;
		return true;
	}
	if (!(chord > SAME_POINT))
		return fault(
		    &interp->at, block->address_column[SINUMERIK_AR],
		    "a circle by its opening angle (AR=) needs a centre (I, J, K), or an end that is not its start");
	/* The centre is beside the middle of the chord; for G3 it is on the left. */
	c->centre.a = (c->start.a + c->end.a) / 2 - sign * (c->end.b - c->start.b) / (2 * math_tan(angle / 2));
	c->centre.b = (c->start.b + c->end.b) / 2 + sign * (c->end.a - c->start.a) / (2 * math_tan(angle / 2));
	return true;
}

static bool in_plane(struct interp *interp, const struct sinumerik_block *block, slot_values *target,
		     const slot_values *start, struct sinumerik_circle *found)
{
	const struct circle_plane *plane = plane_of(interp->state.plane);
	struct circle c = {.plane = plane, .clockwise = interp->state.motion == G2};
	const bool radius = sinumerik_block_has_address(block, SINUMERIK_CR);
	const bool angle = sinumerik_block_has_address(block, SINUMERIK_AR);
	const bool polar = block->addresses & SINUMERIK_POLAR_BITS;
	const bool tangent = interp->state.motion == SINUMERIK_CT;
	const bool centred = polar || block->letters & (letter_bit('I') | letter_bit('J') | letter_bit('K'));
	vec3 centre = slot_values_linear(start);
	double at[3] = {centre.x, centre.y, centre.z}, sweep;

	c.start = (struct plane_point){start->v[plane->a], start->v[plane->b]};
	c.end = (struct plane_point){target->v[plane->a], target->v[plane->b]};
	if (tangent && (radius || angle || centred || sinumerik_block_has_address(block, SINUMERIK_TURN)))
		return fault(&interp->at, circle_column(block),
			     "CT has only an end: no centre, CR=, AR=, TURN=, AP= or RP=");
	if (polar && (radius || angle || block->letters & (letter_bit('I') | letter_bit('J') | letter_bit('K'))))
		return fault(&interp->at, circle_column(block),
			     "a circle to AP= and RP= has its centre at the pole, and no CR=, AR=, I, J or K");
	if (radius + centred > 1 || (radius && angle))
		return fault(
		    &interp->at, circle_column(block),
		    "a circle has a centre (I, J, K), a radius (CR=), or an opening angle (AR=) with one of end "
		    "and centre");
	if (!radius && !centred && !angle && !tangent)
		return fault(&interp->at, circle_column(block),
			     "a circle needs a centre (I, J, K), a radius (CR=) or an opening angle (AR=)");
	if (!find_turns(interp, block, &c.turns))
		return false;
	if (tangent && (!by_tangent(interp, block, &c, &found->straight) || found->straight))
		return found->straight;
	if (radius ? !by_radius(interp, block, &c) : centred && !by_centre(interp, block, &c))
		return false;
	if (angle && !by_angle(interp, block, centred, &c, &sweep))
		return false;
	target->v[plane->a] = c.end.a;
	target->v[plane->b] = c.end.b;
	sweep = arc_sweep(c.start, c.end, c.centre, c.clockwise, c.turns,
			  fmax(SAME_ANGLE, SAME_POINT / math_hypot(c.start.a - c.centre.a, c.start.b - c.centre.b)));
	at[plane->a] = c.centre.a;
	at[plane->b] = c.centre.b;
	*found = (struct sinumerik_circle){.in_plane = true, .clockwise = c.clockwise, .turns = c.turns,
					   .centre = {c.centre.a + interp->state.offset.v[plane->a],
						      c.centre.b + interp->state.offset.v[plane->b]}};
	return place_arc(interp, block, plane, (vec3){at[0], at[1], at[2]}, plane->normal, sweep, &found->arc);
}

bool sinumerik_circle_find(struct interp *interp, const struct sinumerik_block *block, slot_values *target,
			   struct sinumerik_circle *found)
{
	const slot_values start = *sinumerik_frame_place(interp);
	const bool through = interp->state.motion == SINUMERIK_CIP;
	const bool *has_axis = interp->config->has_axis;
	const struct circle_plane *plane = plane_of(interp->state.plane);

	if (through && !(has_axis[SLOT_X] && has_axis[SLOT_Y] && has_axis[SLOT_Z]))
		return fault(&interp->at, circle_column(block), "CIP needs the axes X, Y and Z");
	if (!through && (!has_axis[plane->a] || !has_axis[plane->b]))
		return fault(&interp->at, circle_column(block),
			     "the machine has no %c axis, which a circle in the plane of G%d needs",
			     AXIS_LETTERS[has_axis[plane->a] ? plane->b : plane->a], interp->state.plane / 10);
	*found = (struct sinumerik_circle){.in_plane = false};
	return through ? through_point(interp, block, &start, target, &found->arc)
		       : in_plane(interp, block, target, &start, found);
}

void sinumerik_circle_keep_tangent(struct interp *interp, const slot_values *from, const slot_values *to,
				   const struct sinumerik_circle *circle)
{
	const struct circle_plane *plane = plane_of(interp->state.plane);
	const double *offset = interp->state.offset.v;
	struct plane_point way = {to->v[plane->a] - from->v[plane->a], to->v[plane->b] - from->v[plane->b]};

	if (circle) {
		const double a = to->v[plane->a] - (circle->centre.a - offset[plane->a]);
		const double b = to->v[plane->b] - (circle->centre.b - offset[plane->b]);

		way = circle->clockwise ? (struct plane_point){b, -a} : (struct plane_point){-b, a};
	}
	sinumerik_of(interp)->tangent = (struct sinumerik_tangent){
		.known = !circle || circle->in_plane, .plane = interp->state.plane, .way = way,
		.end = {to->v[plane->a], to->v[plane->b]}};
}
