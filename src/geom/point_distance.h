/* point_distance.h - the distance of a point from the surface of a mesh. */
#ifndef FIVECHECK_GEOM_POINT_DISTANCE_H
#define FIVECHECK_GEOM_POINT_DISTANCE_H

#include <stdbool.h>
#include <stdint.h>

#include "geom/bvh.h"
#include "geom/vec3.h"

/* mm, to within rounding; traverses the tree. */
double mesh_point_distance(const struct bvh *bvh, vec3 point);

/* The same if it is more than `enough` mm; else the distance of any triangle within `enough`, which is found faster. */
double mesh_point_distance_above(const struct bvh *bvh, vec3 point, double enough);

/* A triangle of the tree, and the distance of a point from it. */
struct nearest_triangle {
	double distance;	/* mm, to within rounding */
	uint32_t triangle;
	vec3 at;	/* its nearest point */
};

/*
 * The triangle that is nearest to the point, or any that is within `enough` mm of it. False: none is nearer than
 * `within` mm. Adds the boxes that it examines to *visits.
 */
bool mesh_nearest_triangle(const struct bvh *bvh, vec3 point, double within, double enough,
			   struct nearest_triangle *nearest, long *visits);

/* mm, to within rounding. */
double triangle_point_distance(const mesh_triangle *triangle, vec3 point);

#endif
