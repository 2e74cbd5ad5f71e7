/* cutter_depth.h - how deep a cutter may enter a part or the stock so that the rest of the cutter is still checked. */
#ifndef FIVECHECK_SCENE_CUTTER_DEPTH_H
#define FIVECHECK_SCENE_CUTTER_DEPTH_H

#include "scene/scene.h"

/*
 * mm: the depth, or half of it, and so on, if the cutter is so thin that no point of it is as deep below its surface
 * (tool_core_depth). A mesh is searched for such points; if none are found, the result is 0: its surface counts.
 */
double cutter_depth(struct scene *scene, int body, double depth);

#endif
