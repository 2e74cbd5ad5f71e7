#include "gcode/dialect/klartext/cycles/klartext_face.h"

#include <math.h>

#include "base/same_double.h"
#include "gcode/dialect/klartext/cycles/klartext_shape.h"

/* Covers a rectangle with these signed sides from a corner, and the tool and its clearance Q357 around it. */
static bool cover(const struct klartext_call_of *call, const double corner[2], double from, double to,
		  struct klartext_region *region)
{
	double side[2], clearance, radius;

	if (!klartext_parameter_length(call, 218, &side[0]) || !klartext_parameter_length(call, 219, &side[1]) ||
	    !klartext_parameter_length(call, 200, &clearance) || !klartext_shape_need_radius(call, &radius))
		return false;
	if (clearance < 0)
		return fault(&call->interp->at, call->column, "a set-up clearance (Q200, Q204) cannot be negative");
	region->centre.x = corner[0] + side[0] / 2;
	region->centre.y = corner[1] + side[1] / 2;
	for (int i = 0; i < 2; i++)
		region->half[i] =
		    fabs(side[i]) / 2 + 2 * radius + fmax(clearance, klartext_parameter_length_or(call, 357, 0));
	region->top = fmax(from, to) + clearance;
	region->bottom = fmin(from, to);
	region->clear = fmax(region->top, fmax(from, to) + klartext_parameter_length_or(call, 204, 0));
	return true;
}

/*
 * "MULTIPASS MILLING (Cycle 230)": from Q227 down to the surface. "FACE MILLING (Cycle 232)": from Q227 down to Q386.
 * Both mill a rectangle Q218 by Q219 that starts at Q225, Q226.
 */
bool klartext_face_at(const struct klartext_call_of *call, struct klartext_region *region)
{
	double start[3], end;

	if (!klartext_parameter_length(call, 225, &start[0]) || !klartext_parameter_length(call, 226, &start[1]) ||
	    !klartext_parameter_length(call, 227, &start[2]))
		return false;
	end = start[2];
	region->fixed = true;
	return (call->cycle->number == 230 || klartext_parameter_length(call, 386, &end)) &&
	       cover(call, start, start[2], end, region);
}

/*
 * TNC 640 user's manual, "FACE MILLING (Cycle 233)": from Q227 down to Q386 over a rectangle Q218 by Q219. The tool
 * stands at the centre of the surface (Q367=0), at a corner (1 to 4, from the lower left), or where the first side
 * begins (-1). Limits at the sides (Q347 to Q349) only make the region smaller.
 */
bool klartext_face_here(const struct klartext_call_of *call, struct klartext_region *region)
{
	static const double places[6][2] = {{0, 0}, {-0.5, -0.5}, {0, 0}, {-1, 0}, {-1, -1}, {0, -1}};
	const double place = klartext_parameter_or(call, 367, -1);
	double corner[2] = {region->centre.x, region->centre.y}, from, to;

	if (!(place >= -1 && place <= 4) || !same_double(floor(place), place))
		return fault(&call->interp->at, call->column, "Q367 of CYCL DEF 233 is a whole number from -1 to 4");
	for (int i = 0; i < 2; i++) {
		double side;

		if (!klartext_parameter_length(call, 218 + i, &side))
			return false;
		corner[i] += places[(int)place + 1][i] * side;
	}
	return klartext_parameter_length(call, 227, &from) && klartext_parameter_length(call, 386, &to) &&
	       cover(call, corner, from, to, region);
}
