/* html_report.h - the report of one program as one HTML file (--report). */
#ifndef FIVECHECK_REPORT_HTML_HTML_REPORT_H
#define FIVECHECK_REPORT_HTML_HTML_REPORT_H

#include <stdbool.h>

#include "base/diag.h"
#include "report/html/html_contents.h"

/*
 * Writes the file, which gets its name when it is complete. False, reported: an existing file with this name is not
 * changed.
 */
bool html_report_write(const struct html_contents *report, const char *path, struct diag *diag);

#endif
