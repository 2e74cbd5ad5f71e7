/* mesh_lint.h - what meshes and the home position have that a careful drawing would not (--check-machine). */
#ifndef FIVECHECK_REPORT_MESH_LINT_H
#define FIVECHECK_REPORT_MESH_LINT_H

#include <stdbool.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "scene/scene.h"

/*
 * Appends meshes that are open, that face both ways or hold degenerate
 * triangles, and bodies that overlap at home. False: a mesh is faulty,
 * reported.
 */
bool mesh_lint_add(struct strbuf *out, struct scene *scene, struct diag *diag);

#endif
