/* corner_depth.h - how deep a body stands in another one, or how far it stands out of it. */
#ifndef FIVECHECK_SCENE_CORNER_DEPTH_H
#define FIVECHECK_SCENE_CORNER_DEPTH_H

#include "base/axes.h"
#include "geom/inside.h"
#include "scene/scene.h"

/*
 * The distance (mm) from the surface of `outer` of that tested point of `inner` which is deepest inside (side
 * INSIDE_YES) or farthest outside (INSIDE_NO), with the axes at `q` (mm, radians); 0: no tested point is on
 * that side more than `beyond` mm from it, which is decided faster. Corners and middles of some triangles are tested.
 */
double corner_depth(struct scene *scene, int inner, int outer, const axis_values *q, enum inside side, double beyond);

#endif
