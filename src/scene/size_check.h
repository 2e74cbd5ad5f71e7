/* size_check.h - doubts about the units of the machine's meshes. */
#ifndef FIVECHECK_SCENE_SIZE_CHECK_H
#define FIVECHECK_SCENE_SIZE_CHECK_H

#include "machine/doubt.h"
#include "scene/scene.h"

/*
 * Compares the size of all bodies together with the longest travel. If it is not too small, doubts single bodies, and
 * links with all their bodies, that are far too small. Bodies with checked="" are left out.
 */
void size_check(const struct scene *scene, struct doubts *doubts);

#endif
