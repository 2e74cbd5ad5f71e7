/*
 * ring_check.h - finds rotary axes that are drawn beside their true position, by the circles of the bodies that turn.
 */
#ifndef FIVECHECK_SCENE_RING_CHECK_H
#define FIVECHECK_SCENE_RING_CHECK_H

#include "machine/doubt.h"
#include "scene/scene.h"

/*
 * Bodies that turn about an axis have circles centred on it: hubs, discs, bores. Appends a doubt about each rotary axis
 * if the bodies on it have whole circles in planes across it, and none of these circles, nor of those of its carrier,
 * is centred on the axis. Axes marked checked="" are left out, and those with a mesh that has not been read or has more
 * than 50,000 triangles.
 */
void ring_check(const struct scene *scene, struct doubts *doubts);

#endif
