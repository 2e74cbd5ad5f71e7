/*
 * ring_check.h - finds rotary axes that are drawn beside their true place, by the circles of the bodies that turn.
 */
#ifndef FIVECHECK_SCENE_RING_CHECK_H
#define FIVECHECK_SCENE_RING_CHECK_H

#include "machine/doubt.h"
#include "scene/scene.h"

/*
 * What turns about an axis has circles about it: hubs, discs, bores. Appends a doubt about each rotary axis for which
 * the bodies on it have whole circles in planes across it, and none of them, nor of what carries it, has its middle on
 * the axis. Axes marked checked="" are left out, and those with a mesh that has not been read or has more than 50,000
 * triangles.
 */
void ring_check(const struct scene *scene, struct doubts *doubts);

#endif
