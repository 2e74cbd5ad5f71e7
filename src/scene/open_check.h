/* open_check.h - bodies with open meshes: what gets inside through a gap would not be seen. */
#ifndef FIVECHECK_SCENE_OPEN_CHECK_H
#define FIVECHECK_SCENE_OPEN_CHECK_H

#include "scene/scene.h"

/* Counts into scene->open_bodies, and sets scene->first_open. Left out are bodies of no checked pair, and checked="". */
void open_check(struct scene *scene);

#endif
