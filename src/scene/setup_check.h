/*
 * setup_check.h - finds likely mistakes in a setup: positions, sizes, reach, tools and work offsets that do not fit the
 * machine.
 */
#ifndef FIVECHECK_SCENE_SETUP_CHECK_H
#define FIVECHECK_SCENE_SETUP_CHECK_H

#include <stdbool.h>

#include "machine/doubt.h"
#include "scene/scene.h"

/*
 * Appends the doubts about the scene's setup, if there is one. Elements marked checked="" are left out.
 */
void setup_check(struct scene *scene, struct doubts *doubts);

#endif
