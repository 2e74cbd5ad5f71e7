/* corner_depth.h - how deep a body is inside another one, or how far it is outside. */
#ifndef FIVECHECK_SCENE_CORNER_DEPTH_H
#define FIVECHECK_SCENE_CORNER_DEPTH_H

#include "base/axes.h"
#include "geom/inside.h"
#include "scene/scene.h"

/*
 * The distance (mm) from the surface of `outer` of the tested point of `inner` that is deepest inside (side INSIDE_YES)
 * or farthest outside (INSIDE_NO), with the axes at `q` (mm, radians). 0: no tested point on that side is more than
 * `beyond` mm from the surface, which is decided faster. The tested points are corners and middles of some triangles.
 */
double corner_depth(struct scene *scene, int inner, int outer, const axis_values *q, enum inside side, double beyond);

#endif
