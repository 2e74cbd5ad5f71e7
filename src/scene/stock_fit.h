/* stock_fit.h - is every part inside the blank that it is cut from, and about as large? */
#ifndef FIVECHECK_SCENE_STOCK_FIT_H
#define FIVECHECK_SCENE_STOCK_FIT_H

#include "machine/doubt.h"
#include "scene/scene.h"

/*
 * Adds DOUBT_OUT_OF_STOCK for each part that reaches outside the stock. A part that is wholly outside is not doubted if
 * another part is inside: it may be cut from a blank of its own. Adds DOUBT_PART_BELOW_STOCK if there is one part, and
 * the stock is many times as large.
 */
void stock_fit_check(struct scene *scene, struct doubts *doubts);

#endif
