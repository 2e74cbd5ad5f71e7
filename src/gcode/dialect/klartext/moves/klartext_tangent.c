#include "gcode/dialect/klartext/moves/klartext_tangent.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "geom/tolerance.h"

bool klartext_tangent_flatten(vec3 *direction)
{
	direction->z = 0;
	if (!(vec3_norm(*direction) > SAME_POINT))
		return false;
	*direction = vec3_unit(*direction);
	return true;
}

vec3 klartext_tangent_across(vec3 direction, int side)
{
	return vec3_scale(side, vec3_cross((vec3){0, 0, 1}, direction));
}

vec3 klartext_tangent_turned(vec3 v, double angle)
{
	return (vec3){math_cos(angle) * v.x - math_sin(angle) * v.y, math_sin(angle) * v.x + math_cos(angle) * v.y, 0};
}

bool klartext_tangent_circle_find(struct interp *interp, vec3 point, vec3 direction,
				  const struct klartext_way_words *words, struct klartext_tangent_circle *circle)
{
	const int side = interp->comp.side;
	const double size = words->size + interp->comp.radius;

	if (words->size < 0 && !(size < -SAME_POINT))
		return fault(&interp->at, words->size_column,
			     "a circle from the side of the workpiece whose radius, %.6g mm, is not greater than the "
			     "tool's, %.6g mm, is not supported",
			     -words->size, interp->comp.radius);
	*circle = (struct klartext_tangent_circle){.centre =
						       vec3_mad(point, size, klartext_tangent_across(direction, side)),
						   .radius = fabs(size),
						   .turn = size > 0 ? side : -side};
	return true;
}

/*
 * Finds where a straight line from `from` touches a circle; the path then continues along the circle in the direction
 * of `turn`. False: `from` lies inside the circle.
 */
static bool touch_from(vec3 from, vec3 centre, double radius, int turn, vec3 *unit)
{
	const vec3 away = {from.x - centre.x, from.y - centre.y, 0};
	const double far = vec3_norm(away);

	if (!(far > radius + SAME_POINT))
		return false;
	*unit = klartext_tangent_turned(vec3_scale(1 / far, away), turn * math_acos(radius / far));
	return true;
}

bool klartext_tangent_touch(struct interp *interp, vec3 from, const struct klartext_tangent_circle *circle,
			    const struct klartext_way_words *words, int turn, struct klartext_tangent_helper *helper)
{
	vec3 unit;

	if (!touch_from(from, circle->centre, words->size, turn, &unit))
		return fault(&interp->at, words->size_column,
			     "the other end of this straight line lies within the circle");
	helper->contour = vec3_mad(circle->centre, circle->radius, unit);
	helper->tool = vec3_mad(circle->centre, words->size, unit);
	return true;
}
