/* head_check.h - compares the direction of the spindle with the bodies of its link: does the tool leave the head? */
#ifndef FIVECHECK_SCENE_HEAD_CHECK_H
#define FIVECHECK_SCENE_HEAD_CHECK_H

#include "machine/doubt.h"
#include "scene/scene.h"

/*
 * Adds DOUBT_SPINDLE_IN_HEAD for each body that most lines beside the spindle's axis meet far ahead of the gauge point.
 * A body that begins at the gauge point, with the head behind it, is drawn in the spindle (an arbor) and is not
 * doubted.
 *
 * If the head is behind the gauge point and nothing ahead of it, the drawing confirms a spindle across Z, such as that
 * of an angle head: removes DOUBT_SPINDLE_ACROSS, and the doubts about the places that such a tool reaches with the
 * rotary axes at 0.
 */
void head_check(const struct scene *scene, struct doubts *doubts);

#endif
