/* pairs.h - which pairs of bodies must be checked, and why the others need not be. */
#ifndef FIVECHECK_SCENE_PAIRS_H
#define FIVECHECK_SCENE_PAIRS_H

#include <stdbool.h>

#include "geom/tolerance.h"
#include "scene/scene.h"

/* Fills scene->pairs (fivecheck(7), "Pairs") with up to `threads` threads, once the meshes are read. */
void pairs_derive(struct scene *scene, double clearance, int threads);

#endif
