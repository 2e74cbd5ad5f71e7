/* corner_depth.h - how deep a body that is set up stands in another one, or how far it stands out of it. */
#ifndef FIVECHECK_SCENE_CORNER_DEPTH_H
#define FIVECHECK_SCENE_CORNER_DEPTH_H

#include "base/diag.h"
#include "geom/inside.h"
#include "scene/scene.h"

/*
 * The distance (mm) from the surface of `outer` of that tested point of `inner` which is deepest inside (side
 * INSIDE_YES) or farthest outside (INSIDE_NO); 0: no tested point is on that side. Corners and middles of some
 * triangles are tested. Both bodies must not move against each other.
 */
double corner_depth(struct scene *scene, int inner, int outer, enum inside side);

#endif
