/*
 * missing_check.h - finds missing elements of a model: bodies on base, spindle or workholding, limits of a travel,
 * holders of tools; also a travel that is longer than the machine.
 */
#ifndef FIVECHECK_SCENE_MISSING_CHECK_H
#define FIVECHECK_SCENE_MISSING_CHECK_H

#include "machine/doubt.h"
#include "scene/scene.h"

/*
 * Does the machine have bodies on three links or more? One with fewer is a sketch, in which nothing counts as missing.
 */
bool missing_is_drawn(const struct scene *scene);

/*
 * Appends the doubts about a drawn machine with a spindle and a workholding, and about the tools of its setup; other
 * machines are not judged. Elements marked checked="" are left out.
 */
void missing_check(const struct scene *scene, struct doubts *doubts);

#endif
