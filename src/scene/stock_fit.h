/* stock_fit.h - is every part inside the blank that it is cut from? */
#ifndef FIVECHECK_SCENE_STOCK_FIT_H
#define FIVECHECK_SCENE_STOCK_FIT_H

#include "base/diag.h"
#include "machine/doubt.h"
#include "scene/scene.h"

/*
 * Adds DOUBT_OUT_OF_STOCK for each part that stands out of the stock. A part that is nowhere in it is not doubted if
 * another one is: it may be cut from a blank of its own. The meshes of parts and stock must have been read.
 */
void stock_fit_check(struct scene *scene, struct doubts *doubts, struct diag *diag);

#endif
