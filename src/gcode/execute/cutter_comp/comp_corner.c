#include "gcode/execute/cutter_comp/comp_corner.h"

#include "base/math/math_functions.h"

#include <math.h>

static bool two_lines(const struct comp_way *before, const struct comp_way *after, struct plane_point *corner)
{
	struct plane_point between = plane_along(after->point, -1, before->point);
	double sine = plane_cross(before->direction, after->direction);

	if (!(fabs(sine) > 0))
		return false;
	*corner = plane_along(before->point, plane_cross(between, after->direction) / sine, before->direction);
	return isfinite(corner->a) && isfinite(corner->b);
}

/* The intersection that is farther along the line, or the nearer one. */
static bool line_and_arc(const struct comp_way *line, const struct comp_way *arc, bool farther,
			 struct plane_point *corner)
{
	struct plane_point to_centre = plane_along(arc->centre, -1, line->point);
	double foot = plane_dot(to_centre, line->direction), height = plane_cross(line->direction, to_centre);
	double half = arc->radius * arc->radius - height * height;

	if (half < 0)
		return false;
	*corner = plane_along(line->point, foot + (farther ? 1 : -1) * sqrt(half), line->direction);
	return true;
}

static bool two_arcs(const struct comp_way *before, const struct comp_way *after, struct plane_point *corner)
{
	struct plane_point between = plane_along(after->centre, -1, before->centre);
	double distance = math_hypot(between.a, between.b), cosine, side, angle;

	if (!(distance > 0) || !(before->radius > 0))
		return false;
	cosine = (before->radius * before->radius + distance * distance - after->radius * after->radius) /
		 (2 * before->radius * distance);
	if (!(fabs(cosine) <= 1))
		return false;
	side = before->inside == after->clockwise ? -1 : 1;
	angle = math_atan2(between.b, between.a) + side * math_acos(cosine);
	*corner = plane_along(before->centre, before->radius, (struct plane_point){math_cos(angle), math_sin(angle)});
	return true;
}

bool comp_corner(const struct comp_way *before, const struct comp_way *after, struct plane_point *corner)
{
	if (before->is_arc && after->is_arc)
		return two_arcs(before, after, corner);
	/* The tool leaves an arc that it follows inside at the first intersection, and enters one at the last. */
	if (before->is_arc)
		return line_and_arc(after, before, !before->inside, corner);
	if (after->is_arc)
		return line_and_arc(before, after, after->inside, corner);
	return two_lines(before, after, corner);
}
