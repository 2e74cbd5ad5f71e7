/* tool_check.h - do the bodies of a tool fit its length, the line of the spindle, and each other? */
#ifndef FIVECHECK_SCENE_TOOL_CHECK_H
#define FIVECHECK_SCENE_TOOL_CHECK_H

#include "machine/doubt.h"
#include "scene/scene.h"

/*
 * Adds DOUBT_HOLDER_TURNED, DOUBT_TOOL_ENDS, DOUBT_TOOL_ASIDE, DOUBT_RADIUS_OFFSET, DOUBT_TOOL_NAME and
 * DOUBT_TOOL_SHARP, tool by tool.
 * Tools that the setup marks checked="" are left out.
 */
void tool_check(const struct scene *scene, struct doubts *doubts);

#endif
