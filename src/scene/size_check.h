/* size_check.h - doubts about the units of the machine's meshes. */
#ifndef FIVECHECK_SCENE_SIZE_CHECK_H
#define FIVECHECK_SCENE_SIZE_CHECK_H

#include "machine/doubt.h"
#include "scene/scene.h"

/*
 * The size of all bodies together against the longest travel; if it is not too small, then single bodies, and links
 * with all that is drawn on them, that are far too small for it. Bodies with checked="" are left out.
 */
void size_check(const struct scene *scene, struct doubts *doubts);

#endif
