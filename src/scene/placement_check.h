/* placement_check.h - finds two bodies in the same place, and rotations that look like radians. */
#ifndef FIVECHECK_SCENE_PLACEMENT_CHECK_H
#define FIVECHECK_SCENE_PLACEMENT_CHECK_H

#include "machine/doubt.h"
#include "scene/scene.h"

/*
 * Adds DOUBT_TWICE for two bodies of machine, fixtures and parts with the same mesh in the same position, and
 * DOUBT_ROTATION for a body or a workholding whose rotation in degrees equals a common angle in radians. Bodies whose
 * meshes have not been read, and tools, are not judged.
 */
void placement_check(const struct scene *scene, struct doubts *doubts);

#endif
