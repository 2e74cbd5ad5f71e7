#include "gcode/dialect/sinumerik/cycles/sinumerik_swivel_plane.h"

#include <math.h>

#include "base/same_double.h"
#include "base/units.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"

/* The upper bits of MODE. */
enum { AXIS_BY_AXIS, BY_SOLID_ANGLES, BY_PROJECTION_ANGLES, BY_ROTARY_AXES };

double sinumerik_swivel_value(const struct sinumerik_swivel *s, size_t i)
{
	return i < s->count && !isnan(s->arguments[i]) ? s->arguments[i] : 0;
}

bool sinumerik_swivel_is_direct(long mode)
{
	return mode >> 6 == BY_ROTARY_AXES;
}

static vec3 point(const struct sinumerik_swivel *s, size_t i)
{
	const vec3 given = {sinumerik_swivel_value(s, i), sinumerik_swivel_value(s, i + 1),
			    sinumerik_swivel_value(s, i + 2)};

	return vec3_scale(s->interp->state.scale, given);
}

static struct sinumerik_frame shift_by(vec3 by)
{
	struct sinumerik_frame frame = sinumerik_frame_none();

	slot_values_set_linear(&frame.shift, by);
	return frame;
}

/*
 * MODE, axis by axis: bits 0 and 1, 2 and 3, 4 and 5 name the axes of the first, second and third rotation (1 X, 2 Y,
 * 3 Z). Each rotation is about the axis as the rotations before have left it. A, B and C are the angles in the order
 * of the rotations. With solid angles, A rotates about Z, and then B about the new Y.
 */
static bool find_turn(const struct sinumerik_swivel *s, long mode, mat3 *turn)
{
	const long axes = mode >> 6 == BY_SOLID_ANGLES ? 3 | 2 << 2 : mode;

	*turn = mat3_identity();
	for (int i = 0; i < 3 && !sinumerik_swivel_is_direct(mode); i++) {
		const long axis = axes >> 2 * i & 3;
		const double angle = sinumerik_swivel_value(s, A + (size_t)i);
		mat3 one;

		if (axis == 0 && !same_double(angle, 0))
			return fault(&s->interp->at, s->column, "MODE=%ld of CYCLE800 names no axis for angle %d", mode,
				     i + 1);
		one = mat3_turn((vec3){axis == 1, axis == 2, axis == 3 || axis == 0}, radians(angle));
		*turn = mat3_mul(turn, &one);
	}
	return true;
}

/* "Swivel plane": two projection angles define the plane like ROTS; the third angle rotates in the plane, about Z. */
static bool find_projection(const struct sinumerik_swivel *s, long mode, mat3 *turn)
{
	const long first = mode & 3, second = mode >> 2 & 3, last = mode >> 4 & 3;
	double angles[4] = {0};
	mat3 in_plane;

	if (first == 0 || second == 0 || first == second ||
	    (last != 3 && !same_double(sinumerik_swivel_value(s, C), 0)))
		return fault(&s->interp->at, s->column,
			     "MODE=%ld of CYCLE800, projection angles, must name two axes and then Z", mode);
	angles[first] = sinumerik_swivel_value(s, A);
	angles[second] = sinumerik_swivel_value(s, B);
	if (!sinumerik_frame_solid((int)(6 - first - second) - 1, (vec3){angles[1], angles[2], angles[3]}, turn))
		return fault(&s->interp->at, s->column,
			     "two projection angles of CYCLE800 must lie between -90 and 90 degrees");
	in_plane = mat3_turn((vec3){0, 0, 1}, radians(sinumerik_swivel_value(s, C)));
	*turn = mat3_mul(turn, &in_plane);
	return true;
}

static bool has_no_angle(const struct sinumerik_swivel *s)
{
	return same_double(sinumerik_swivel_value(s, A), 0) && same_double(sinumerik_swivel_value(s, B), 0) &&
	       same_double(sinumerik_swivel_value(s, C), 0);
}

/*
 * "Swivel plane", new and additive: a new plane deletes the active planes and programmable frames; an added plane
 * includes them.
 */
bool sinumerik_swivel_plane(const struct sinumerik_swivel *s, long mode, bool added, struct sinumerik_frame *plane)
{
	const struct sinumerik *sinumerik = sinumerik_of(s->interp);
	struct sinumerik_frame before = shift_by(point(s, X0)), turn = sinumerik_frame_none(),
			       after = shift_by(point(s, X1)), under;

	if (mode < 0 || mode > 255)
		return fault(&s->interp->at, s->column, "MODE of CYCLE800 must lie between 0 and 255, not %ld", mode);
	if (sinumerik_swivel_is_direct(mode) && !has_no_angle(s))
		return fault(&s->interp->at, s->column,
			     "MODE=%ld of CYCLE800, a plane by positions of the rotary axes, is not supported other "
			     "than 0: in which direction X of the plane then points is not certain; axis by axis (MODE="
			     "57 and the like) it is",
			     mode);
	if (mode >> 6 == BY_PROJECTION_ANGLES ? !find_projection(s, mode, &turn.matrix)
					      : !find_turn(s, mode, &turn.matrix))
		return false;
	before = sinumerik_frame_chain(&before, &turn);
	*plane = sinumerik_frame_chain(&before, &after);
	if (!added)
		return true;
	if (s->interp->state.frame.on && s->interp->state.frame.distorts)
		return fault(&s->interp->at, s->column,
			     "CYCLE800 that adds a plane (units of ST 1) while SCALE or MIRROR is in force is not "
			     "supported");
	under = sinumerik_frame_total(sinumerik);
	*plane = sinumerik_frame_chain(&under, plane);
	return true;
}
