/* neighbour_check.h - finds neighbours that are excused from the proof, but meet when their joint moves. */
#ifndef FIVECHECK_SCENE_NEIGHBOUR_CHECK_H
#define FIVECHECK_SCENE_NEIGHBOUR_CHECK_H

#include "machine/doubt.h"
#include "scene/scene.h"

/*
 * Adds a doubt for each pair that is excused as neighbours (PAIR_ADJACENT) if one of them is deeper inside the other
 * somewhere in the travel of their joint than at home. Tests a few positions, and some points of each body.
 */
void neighbour_check(struct scene *scene, struct doubts *doubts);

#endif
