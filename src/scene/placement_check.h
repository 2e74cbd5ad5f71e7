/* placement_check.h - finds bodies that stand where another one stands, and rotations that look like radians. */
#ifndef FIVECHECK_SCENE_PLACEMENT_CHECK_H
#define FIVECHECK_SCENE_PLACEMENT_CHECK_H

#include "machine/doubt.h"
#include "scene/scene.h"

/*
 * Adds DOUBT_TWICE for two bodies of machine, fixtures and parts that have one mesh in one place, and DOUBT_ROTATION
 * for a body or a workholding that is turned by so many degrees as common angles have radians. Bodies whose meshes
 * have not been read, and tools, are not judged.
 */
void placement_check(const struct scene *scene, struct doubts *doubts);

#endif
