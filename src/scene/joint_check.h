/* joint_check.h - is every moving link drawn near its carrier, or is a body between them missing? */
#ifndef FIVECHECK_SCENE_JOINT_CHECK_H
#define FIVECHECK_SCENE_JOINT_CHECK_H

#include "machine/doubt.h"
#include "scene/scene.h"

/*
 * Adds DOUBT_GAP for each link whose bodies are all far from the bodies of the links that carry it, at home. Links
 * without bodies, and those whose meshes have not been read, are not judged. Then adds DOUBT_EXCUSED_APART if
 * `adjacent_within` is so large that it excuses bodies which are no neighbours; the scene's pairs must have been
 * derived.
 */
void joint_check(struct scene *scene, struct doubts *doubts);

#endif
