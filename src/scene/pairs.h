/* pairs.h - derives which pairs of bodies must be checked, and the reasons for the others. */
#ifndef FIVECHECK_SCENE_PAIRS_H
#define FIVECHECK_SCENE_PAIRS_H

#include <stdbool.h>

#include "geom/tolerance.h"
#include "scene/scene.h"

/* Fills scene->pairs (fivecheck(7), "Pairs") with up to `threads` threads, after the meshes are read. */
void pairs_derive(struct scene *scene, double clearance, int threads);

#endif
