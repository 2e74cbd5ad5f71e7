/*
 * missing_check.h - finds what a model lacks: bodies that hold the machine, the spindle or the work, the ends of a
 * travel, the holders of tools; and a travel that is longer than the machine.
 */
#ifndef FIVECHECK_SCENE_MISSING_CHECK_H
#define FIVECHECK_SCENE_MISSING_CHECK_H

#include "machine/doubt.h"
#include "scene/scene.h"

/*
 * Has the machine bodies on three links or more? One with fewer is a sketch, in which nothing is missed.
 */
bool missing_is_drawn(const struct scene *scene);

/*
 * Appends the doubts about a machine that is drawn and has a spindle and a workholding, and about its setup's tools; of
 * other machines nothing is said. Elements marked checked="" are left out.
 */
void missing_check(const struct scene *scene, struct doubts *doubts);

#endif
