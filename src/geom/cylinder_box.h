/* cylinder_box.h - the distance of a solid cylinder from a solid box. */
#ifndef FIVECHECK_GEOM_CYLINDER_BOX_H
#define FIVECHECK_GEOM_CYLINDER_BOX_H

#include "geom/vec3.h"

/* All lengths in mm. */
struct cylinder {
	vec3 base;	/* the middle of one end */
	vec3 along;	/* unit, from that end to the other */
	double length, radius;	/* at least 0 */
};

/* Its sides are along X, Y and Z. */
struct solid_box {
	vec3 middle, half;
};

/*
 * The distance (mm); 0 if they meet. It is the distance of two of their points, so it is never too small; it exceeds
 * the true distance by at most a hundredth, or by a few hundredths of a mm where an edge grazes. The search ends early
 * once it is below `enough`.
 *
 * Method: alternating projections, which end at the nearest points of two convex sets (Cheney and Goldstein, 1959).
 */
double cylinder_box_distance(const struct cylinder *cylinder, const struct solid_box *box, double enough);

#endif
