/* mesh_lint.h - lists what is odd about meshes and the home position (--check-machine). */
#ifndef FIVECHECK_REPORT_MESH_LINT_H
#define FIVECHECK_REPORT_MESH_LINT_H

#include <stdbool.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "scene/scene.h"

/*
 * Appends meshes that are open, face both ways or hold degenerate triangles, and bodies that overlap at home. False,
 * reported: a mesh is faulty.
 */
bool mesh_lint_add(struct strbuf *out, struct scene *scene, struct diag *diag);

#endif
