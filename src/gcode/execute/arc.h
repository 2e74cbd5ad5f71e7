/* arc.h - the centre and the sweep of G2 and G3 in their plane. */
#ifndef FIVECHECK_GCODE_EXECUTE_ARC_H
#define FIVECHECK_GCODE_EXECUTE_ARC_H

#include <stdbool.h>

#include "gcode/execute/plane_point.h"

enum arc_status {
	ARC_OK,
	ARC_ZERO_RADIUS,
	ARC_RADII_DIFFER,
	ARC_NO_CHORD,	/* given by radius, and the end is the start */
	ARC_RADIUS_TOO_SMALL	/* to reach the end */
};

/* In mm. LinuxCNC has one set of tolerances for programs in mm and one for programs in inches. */
struct arc_tolerance {
	double radius;	/* the smallest radius; also by how much R may be less than half the chord */
	double spiral;	/* the greatest difference of the radii of start and end */
};

extern const struct arc_tolerance arc_tolerance_mm, arc_tolerance_inch;

/* Checks the radii of an arc given by its centre. Always sets *start_radius and *end_radius. */
enum arc_status arc_check_centre(struct plane_point start, struct plane_point end, struct plane_point centre,
				 const struct arc_tolerance *tolerance, double *start_radius, double *end_radius);

/* Finds the centre of an arc given by its radius; with a negative radius the arc is longer than half a turn. */
enum arc_status arc_find_centre(struct plane_point start, struct plane_point end, double radius, bool clockwise,
				const struct arc_tolerance *tolerance, struct plane_point *centre);

/*
 * The angle from start to end about the centre in the given direction, positive counter-clockwise, plus `turns` - 1
 * full turns. An angle of at most `least` radians counts as a full turn.
 */
double arc_sweep(struct plane_point start, struct plane_point end, struct plane_point centre, bool clockwise, int turns,
		 double least);

#endif
