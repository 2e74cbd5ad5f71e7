/*
 * model_check.h - finds likely mistakes in the drawing of a machine and in a setup: positions, sizes and units that do
 * not fit each other.
 */
#ifndef FIVECHECK_SCENE_MODEL_CHECK_H
#define FIVECHECK_SCENE_MODEL_CHECK_H

#include "machine/doubt.h"
#include "scene/scene.h"

/*
 * Fills scene->doubts: the doubts about the machine's motions (kinematics_check), then those about its bodies and the
 * setup. They do not depend on the number of threads.
 */
void model_check(struct scene *scene, int threads);

#endif
