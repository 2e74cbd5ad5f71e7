#include "gcode/dialect/klartext/cycles/klartext_points.h"

#include "base/math/math_functions.h"

bool klartext_points_add(struct interp *interp, int column, vec3 point)
{
	struct klartext_points *points = &klartext_of(interp)->points;

	if (points->count == KLARTEXT_POINTS_MAX)
		return fault(&interp->at, column, "a pattern has at most %d points", KLARTEXT_POINTS_MAX);
	points->items[points->count++] = point;
	return true;
}

void klartext_points_begin(struct interp *interp)
{
	struct klartext_points *points = &klartext_of(interp)->points;

	points->count = 0;
	points->any_order = points->surface = points->single = false;
}

static vec3 polar(vec3 from, double radius, double angle)
{
	return (vec3){from.x + radius * math_cos_degrees(angle), from.y + radius * math_sin_degrees(angle), from.z};
}

bool klartext_points_add_grid(struct interp *interp, int column, const struct klartext_grid *grid)
{
	const int last[2] = {grid->count[0] - 1, grid->count[1] - 1};

	for (int row = 0; row <= last[1]; row++) {
		const vec3 begin = polar(grid->start, row * grid->spacing[1], grid->angle[1]);

		for (int i = 0; i <= last[0]; i++) {
			const int at = grid->zigzag && row % 2 == 1 ? last[0] - i : i;

			if (grid->frame && row > 0 && row < last[1] && at > 0 && at < last[0])
				continue;
			if (!klartext_points_add(interp, column, polar(begin, at * grid->spacing[0], grid->angle[0])))
				return false;
		}
	}
	return true;
}

bool klartext_points_add_circle(struct interp *interp, int column, vec3 centre, double diameter, double start,
				double step, int count)
{
	for (int i = 0; i < count; i++) {
		if (!klartext_points_add(interp, column, polar(centre, diameter / 2, start + i * step)))
			return false;
	}
	return true;
}
