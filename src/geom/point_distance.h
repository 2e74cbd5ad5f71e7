/* point_distance.h - how far a point is from the surface of a mesh. */
#ifndef FIVECHECK_GEOM_POINT_DISTANCE_H
#define FIVECHECK_GEOM_POINT_DISTANCE_H

#include "geom/bvh.h"
#include "geom/vec3.h"

/* mm, to within rounding; costs a walk down the tree. */
double mesh_point_distance(const struct bvh *bvh, vec3 point);

#endif
