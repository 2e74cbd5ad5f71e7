/* point_distance.h - how far a point is from the surface of a mesh. */
#ifndef FIVECHECK_GEOM_POINT_DISTANCE_H
#define FIVECHECK_GEOM_POINT_DISTANCE_H

#include <stdbool.h>
#include <stdint.h>

#include "geom/bvh.h"
#include "geom/vec3.h"

/* mm, to within rounding; costs a walk down the tree. */
double mesh_point_distance(const struct bvh *bvh, vec3 point);

/* A triangle of the tree, and how far a point is from it. */
struct nearest_triangle {
	double distance;	/* mm, to within rounding */
	uint32_t triangle;
};

/*
 * The triangle that is nearest to the point. False: none is nearer than `within` mm. Adds the boxes that it looks at to
 * *visits.
 */
bool mesh_nearest_triangle(const struct bvh *bvh, vec3 point, double within, struct nearest_triangle *nearest,
			   long *visits);

#endif
