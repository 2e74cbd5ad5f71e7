/* setup_check.h - does what is set up fit the machine: places, sizes, reach, tools, work offsets. */
#ifndef FIVECHECK_SCENE_SETUP_CHECK_H
#define FIVECHECK_SCENE_SETUP_CHECK_H

#include <stdbool.h>

#include "machine/doubt.h"
#include "scene/scene.h"

/*
 * Appends the doubts about the scene's setup, if it has one. The meshes of fixtures, parts and of the workholding's
 * link have been read. Elements that are marked checked="" are left out.
 */
void setup_check(struct scene *scene, struct doubts *doubts, struct diag *diag);

#endif
