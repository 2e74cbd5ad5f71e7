/*
 * missing_check.h - finds what a model lacks: bodies that hold the machine, the spindle or the work, the ends of a
 * travel, the holders of tools; and a travel that is longer than the machine.
 */
#ifndef FIVECHECK_SCENE_MISSING_CHECK_H
#define FIVECHECK_SCENE_MISSING_CHECK_H

#include "machine/doubt.h"
#include "scene/scene.h"

/*
 * Appends the doubts about a machine with a spindle, a workholding, and bodies on three links or more, and about its
 * setup's tools; of other machines nothing is said. Elements marked checked="" are left out. Lengths of travels are compared with the bodies
 * only if all of their meshes have been read.
 */
void missing_check(const struct scene *scene, struct doubts *doubts);

#endif
