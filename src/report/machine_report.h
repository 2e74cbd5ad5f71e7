/* machine_report.h - prints how a machine file was understood (--check-machine). */
#ifndef FIVECHECK_REPORT_MACHINE_REPORT_H
#define FIVECHECK_REPORT_MACHINE_REPORT_H

#include <stdbool.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "scene/scene.h"

/*
 * Appends the tree of axes with their bodies (triangles, bounds in machine coordinates at the zero pose), the table of
 * which axis carries which (Table I of Chen, Lin and Chang), and what a positive value of each axis does. False,
 * reported: a mesh is faulty.
 */
bool machine_report_add(struct strbuf *out, struct scene *scene, struct diag *diag);

#endif
