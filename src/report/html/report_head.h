/* report_head.h - the JSON object of a report (report_data.h). */
#ifndef FIVECHECK_REPORT_HTML_REPORT_HEAD_H
#define FIVECHECK_REPORT_HTML_REPORT_HEAD_H

#include <jansson.h>

#include "report/html/html_contents.h"

/*
 * Everything but path, clearance, planes and code. A copy, because threads that write reports at the same time share
 * the scene.
 */
json_t *report_head_json(const struct html_contents *report);

#endif
