#include "gcode/dialect/klartext/cycles/klartext_shape.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/same_double.h"

bool klartext_shape_size(const struct klartext_call_of *call, int q, double *value)
{
	double length;

	if (!klartext_parameter_length(call, q, &length))
		return false;
	if (length < 0)
		return fault(&call->interp->at, call->column, "Q%d of CYCL DEF %d is a size and cannot be negative", q,
			     call->cycle->number);
	*value = length;
	return true;
}

void klartext_shape_turn(struct klartext_region *region, double along, double across, double degrees)
{
	const double c = fabs(math_cos_degrees(degrees)), s = fabs(math_sin_degrees(degrees));

	region->half[0] = c * along + s * across;
	region->half[1] = s * along + c * across;
}

bool klartext_shape_place(const struct klartext_call_of *call, const double places[5][2], double way[2])
{
	const double place = klartext_parameter_or(call, 367, 0);

	if (!(place >= 0 && place <= 4) || !same_double(floor(place), place))
		return fault(&call->interp->at, call->column, "Q367 of CYCL DEF %d is a whole number from 0 to 4",
			     call->cycle->number);
	way[0] = places[(int)place][0];
	way[1] = places[(int)place][1];
	return true;
}

void klartext_shape_shift(struct klartext_region *region, double x, double y, double degrees)
{
	region->centre.x += math_cos_degrees(degrees) * x - math_sin_degrees(degrees) * y;
	region->centre.y += math_sin_degrees(degrees) * x + math_cos_degrees(degrees) * y;
}

double klartext_shape_tool_radius(const struct klartext_call_of *call)
{
	const struct tool *tool = tool_table_find(&call->interp->tools, call->interp->state.tool);

	return tool ? fmax(0, tool->diameter / 2 + fmin(0, klartext_of(call->interp)->tool.delta_radius)) : 0;
}

void klartext_shape_disc(struct klartext_region *region, double diameter, double radius)
{
	region->half[0] = region->half[1] = fmax(0, diameter / 2 - radius);
}

bool klartext_shape_need_radius(const struct klartext_call_of *call, double *radius)
{
	const struct tool *tool = tool_table_find(&call->interp->tools, call->interp->state.tool);

	if (!tool || !(tool->diameter > 0))
		return fault(&call->interp->at, call->column,
			     "CYCL DEF %d needs the radius of the tool: give the tool of the setup a <cutter>, or "
			     "diameter=\"\"",
			     call->cycle->number);
	*radius = tool->diameter / 2 + fmax(0, klartext_of(call->interp)->tool.delta_radius);
	return true;
}

bool klartext_shape_middle(const struct klartext_call_of *call, struct klartext_region *region)
{
	region->fixed = true;
	return klartext_parameter_length(call, 216, &region->centre.x) &&
	       klartext_parameter_length(call, 217, &region->centre.y);
}
