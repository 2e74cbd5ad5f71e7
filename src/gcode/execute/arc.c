#include "gcode/execute/arc.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/units.h"

/*
 * LinuxCNC 2.9, interp_internal.hh: RADIUS_TOLERANCE and CENTER_ARC_RADIUS_TOLERANCE
 * (2 sqrt 2 thousandths of an inch, or hundredths of a mm).
 */
const struct arc_tolerance arc_tolerance_mm = {0.00005 * MM_PER_INCH, 0.028284271247461903};
const struct arc_tolerance arc_tolerance_inch = {0.00005 * MM_PER_INCH, 0.0028284271247461903 * MM_PER_INCH};

/* The same source: a greater difference of the radii is accepted if it is below this share of the radius ... */
#define SPIRAL_RELATIVE_TOLERANCE 0.001
/* ... and below this multiple of the tolerance. */
#define SPIRAL_GREATEST 100

enum arc_status arc_check_centre(struct plane_point start, struct plane_point end, struct plane_point centre,
				 const struct arc_tolerance *tolerance, double *start_radius, double *end_radius)
{
	double difference;

	*start_radius = math_hypot(start.a - centre.a, start.b - centre.b);
	*end_radius = math_hypot(end.a - centre.a, end.b - centre.b);
	if (*start_radius < tolerance->radius || *end_radius < tolerance->radius)
		return ARC_ZERO_RADIUS;
	difference = fabs(*start_radius - *end_radius);
	if (difference > SPIRAL_GREATEST * tolerance->spiral)
		return ARC_RADII_DIFFER;
	if (difference > tolerance->spiral && difference > SPIRAL_RELATIVE_TOLERANCE * fmax(*start_radius, *end_radius))
		return ARC_RADII_DIFFER;
	return ARC_OK;
}

enum arc_status arc_find_centre(struct plane_point start, struct plane_point end, double radius, bool clockwise,
				const struct arc_tolerance *tolerance, struct plane_point *centre)
{
	struct plane_point half = {(end.a - start.a) / 2, (end.b - start.b) / 2};
	double length = math_hypot(half.a, half.b), size = fabs(radius), height = 0, side;

	if (!(length > 0))
		return ARC_NO_CHORD;
	if (length - size > tolerance->radius)
		return ARC_RADIUS_TOO_SMALL;
	if (size > length)
		height = sqrt((size - length) * (size + length));
	/* The centre of a clockwise arc of less than half a turn is to the right of the chord. */
	side = clockwise == (radius > 0) ? -1 : 1;
	centre->a = start.a + half.a - side * height * half.b / length;
	centre->b = start.b + half.b + side * height * half.a / length;
	return ARC_OK;
}

double arc_sweep(struct plane_point start, struct plane_point end, struct plane_point centre, bool clockwise, int turns,
		 double least)
{
	double sa = start.a - centre.a, sb = start.b - centre.b, ea = end.a - centre.a, eb = end.b - centre.b;
	double angle = math_atan2(sa * eb - sb * ea, sa * ea + sb * eb);	/* -pi to pi */
	double sweep = clockwise ? -angle : angle;

	if (fabs(sweep) <= least)
		sweep = 2 * PI;
	else if (sweep < 0)
		sweep += 2 * PI;
	sweep += 2 * PI * (turns - 1);
	return clockwise ? -sweep : sweep;
}
