/* machine_report.h - prints how a machine file was understood (--check-machine). */
#ifndef FIVECHECK_REPORT_MACHINE_REPORT_H
#define FIVECHECK_REPORT_MACHINE_REPORT_H

#include <stdbool.h>

#include "base/strbuf.h"
#include "report/oddities.h"
#include "scene/scene.h"

/*
 * Appends the tree of axes with their bodies (triangles, bounds in machine coordinates at the zero pose), the table of
 * which axis carries which (Table I of Chen, Lin and Chang), and what a positive value of each axis does.
 */
void machine_report_add(struct strbuf *out, struct scene *scene);

/* Appends the list of oddities. */
void machine_report_add_oddities(struct strbuf *out, const struct oddities *oddities);

/* The names of roles in reports: "body", "fixture", "part", "holder", "shank", "cutter". */
const char *machine_report_role(enum body_role role);

/* "linear", "dogleg", "any" */
const char *machine_report_rapid(enum rapid rapid);

/* The bounds of all corners of the mesh after placement: machine coordinates at the zero pose. */
void machine_report_bounds(const struct mesh *mesh, const xform *placement, vec3 *least, vec3 *greatest);

#endif
