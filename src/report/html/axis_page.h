/* axis_page.h - one HTML page that shows the motion of each axis of a machine (--check-machine --report, import). */
#ifndef FIVECHECK_REPORT_HTML_AXIS_PAGE_H
#define FIVECHECK_REPORT_HTML_AXIS_PAGE_H

#include <stdbool.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "scene/scene.h"

/* Writes the same to a file. */
bool axis_page_write(const char *path, struct scene *scene, struct diag *diag);

#endif
