/* open_check.h - bodies with open meshes: a body that enters one through a gap would not be noticed. */
#ifndef FIVECHECK_SCENE_OPEN_CHECK_H
#define FIVECHECK_SCENE_OPEN_CHECK_H

#include "scene/scene.h"

/* Fills scene->open_bodies and first_open. Bodies of no checked pair, and those with checked="", do not count. */
void open_check(struct scene *scene);

/* What open_check will ask about this body, so that several threads can find it: it takes long for a fine mesh. */
void open_check_prepare(struct scene *scene, int body);

#endif
