/* pairs.h - which pairs of bodies must be checked, and why the others need not be. */
#ifndef FIVECHECK_SCENE_PAIRS_H
#define FIVECHECK_SCENE_PAIRS_H

#include <stdbool.h>

#include "scene/scene.h"

/*
 * mm and radians: proofs of "out of reach" go this far past the limits, so that
 * the rounding of positions and small path tolerances stay inside them.
 */
#define REACH_MARGIN 1e-3

/* Fills scene->pairs (fivecheck(7), "Pairs"). False: a mesh was faulty, reported. */
bool pairs_derive(struct scene *scene, double clearance, struct diag *diag);

#endif
