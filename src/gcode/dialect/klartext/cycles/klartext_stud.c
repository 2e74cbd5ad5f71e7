#include "gcode/dialect/klartext/cycles/klartext_stud.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/same_double.h"
#include "gcode/dialect/klartext/cycles/klartext_shape.h"

/* mm: "starting position 2 mm to the right of the unmachined stud" (TNC 640, "RECTANGULAR STUD (Cycle 256)"). */
#define STUD_SIDE 2.0

/*
 * The room beside the blank where the tool may start. The manual asks for the tool's diameter and 2 mm, for a
 * semicircle from outside. Some controls start at the set-up clearance beside the blank.
 */
static double beside_stud(const struct klartext_call_of *call, double radius)
{
	return 3 * radius + fmax(STUD_SIDE, klartext_parameter_length_or(call, 200, 0));
}

/* "RECTANGULAR STUD (Cycle 256)": Q218 by Q219 from a blank Q424 by Q425. */
bool klartext_stud_rectangle(const struct klartext_call_of *call, struct klartext_region *region)
{
	static const double places[5][2] = {{0, 0}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
	const double turn = klartext_parameter_or(call, 224, 0);
	double length, width, blank[2], radius, way[2], most;

	if (!klartext_shape_size(call, 218, &length) || !klartext_shape_size(call, 219, &width) ||
	    !klartext_shape_size(call, 424, &blank[0]) || !klartext_shape_size(call, 425, &blank[1]) ||
	    !klartext_shape_need_radius(call, &radius) || !klartext_shape_place(call, places, way))
		return false;
	klartext_shape_shift(region, way[0] * length / 2, way[1] * width / 2, turn);
	most = fmax(fmax(length, width), fmax(blank[0], blank[1])) / 2 + beside_stud(call, radius);
	klartext_shape_turn(region, most, most, turn);
	return true;
}

/*
 * TNC 426 user's manual, "STUD FINISHING (Cycle 213)", "CIRCULAR STUD FINISHING (Cycle 215)": about Q216, Q217, from a
 * blank Q218 by Q219 with the allowance Q221, or from a blank of diameter Q222. The tool comes from "3.5 times the tool
 * radius" beside it.
 */
bool klartext_stud_finish(const struct klartext_call_of *call, struct klartext_region *region)
{
	const bool round = call->cycle->number == 215;
	double size[2], radius, aside;

	if (!klartext_shape_middle(call, region) || !klartext_shape_size(call, round ? 222 : 218, &size[0]) ||
	    !klartext_shape_size(call, round ? 223 : 219, &size[1]) || !klartext_shape_need_radius(call, &radius))
		return false;
	aside = 4 * radius + STUD_SIDE + fabs(klartext_parameter_length_or(call, 221, 0));
	for (int i = 0; i < 2; i++)
		region->half[i] = (round ? fmax(size[0], size[1]) : size[i]) / 2 + aside;
	return true;
}

/* "CIRCULAR STUD (Cycle 257)": diameter Q223 from a blank of diameter Q222. */
bool klartext_stud_circle(const struct klartext_call_of *call, struct klartext_region *region)
{
	double diameter, blank, radius;

	if (!klartext_shape_size(call, 223, &diameter) || !klartext_shape_size(call, 222, &blank) ||
	    !klartext_shape_need_radius(call, &radius))
		return false;
	region->half[0] = region->half[1] = fmax(diameter, blank) / 2 + beside_stud(call, radius);
	return true;
}

/*
 * "POLYGON STUD (Cycle 258)": Q572 corners on a circle of diameter Q571, or about this circle with Q573=0; from a blank
 * of diameter Q222.
 */
bool klartext_stud_polygon(const struct klartext_call_of *call, struct klartext_region *region)
{
	const double about = klartext_parameter_or(call, 573, 0);
	double diameter, blank, corners, radius;

	if (!klartext_shape_size(call, 571, &diameter) || !klartext_shape_size(call, 222, &blank) ||
	    !klartext_parameter_need(call, 572, &corners) || !klartext_shape_need_radius(call, &radius))
		return false;
	if (!(corners >= 3 && corners <= 30) || !same_double(floor(corners), corners))
		return fault(&call->interp->at, call->column, "Q572 of CYCL DEF 258 is a whole number from 3 to 30");
	if (same_double(about, 0))
		diameter /= math_cos_degrees(180 / corners);
	else if (!same_double(about, 1))
		return fault(&call->interp->at, call->column, "Q573 of CYCL DEF 258 is 0 or 1");
	region->half[0] = region->half[1] = fmax(diameter, blank) / 2 + beside_stud(call, radius);
	return true;
}

/* "OUTSIDE THREAD MILLING (Cycle 267)": diameter Q335 and pitch Q239; Q358 and Q359 countersink at the front. */
bool klartext_stud_thread(const struct klartext_call_of *call, struct klartext_region *region)
{
	double diameter, pitch, radius;

	if (!klartext_shape_size(call, 335, &diameter) || !klartext_parameter_length(call, 239, &pitch) ||
	    !klartext_shape_need_radius(call, &radius))
		return false;
	region->half[0] = region->half[1] = diameter / 2 + beside_stud(call, radius) + fabs(pitch) +
					    fabs(klartext_parameter_length_or(call, 359, 0));
	region->beyond = fabs(pitch);
	region->bottom = fmin(region->bottom, klartext_parameter_length_or(call, 203, 0) +
						  klartext_parameter_length_or(call, 358, 0));
	return true;
}
