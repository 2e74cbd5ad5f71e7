/* shown_body.h - the bodies and pairs of a scene as a report shows them: the core of a cutter counts as the cutter. */
#ifndef FIVECHECK_REPORT_HTML_SHOWN_BODY_H
#define FIVECHECK_REPORT_HTML_SHOWN_BODY_H

#include "scene/scene.h"

/* The index of the body in the report; for a core, that of its cutter. */
int shown_body(const struct scene *scene, int body);

/* The index of the body with that name; -1: there is none, or the name is NULL. */
int shown_body_named(const struct scene *scene, const char *name);

/* The pose of its mesh in machine coordinates, with the axes at q. */
xform shown_body_pose(const struct scene *scene, int body, const axis_values *q);

/* The pair of these bodies, as in a finding; for a cutter and the part any of their pairs. NULL: there is none. */
const struct scene_pair *shown_pair(const struct scene *scene, int a, int b);

#endif
