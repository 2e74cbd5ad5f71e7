/* pairs.h - which pairs of bodies must be checked, and why the others need not be. */
#ifndef FIVECHECK_SCENE_PAIRS_H
#define FIVECHECK_SCENE_PAIRS_H

#include <stdbool.h>

#include "geom/tolerance.h"
#include "scene/scene.h"

/*
 * Reads the meshes that pairs_derive will look at, with up to `threads` threads. What is wrong with a mesh is reported
 * in the order in which pairs_derive would have met it.
 */
void pairs_read_meshes(struct scene *scene, int threads, struct diag *diag);

/*
 * Fills scene->pairs (fivecheck(7), "Pairs"), with up to `threads` threads: then after pairs_read_meshes. False: a mesh
 * was faulty, reported.
 */
bool pairs_derive(struct scene *scene, double clearance, int threads, struct diag *diag);

#endif
