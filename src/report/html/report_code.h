/* report_code.h - the text of a program and its subprograms in a report: report_data.h, "CODE". */
#ifndef FIVECHECK_REPORT_HTML_REPORT_CODE_H
#define FIVECHECK_REPORT_HTML_REPORT_CODE_H

#include <jansson.h>
#include <stddef.h>

#include "report/html/html_contents.h"
#include "report/html/page.h"

/* Writes the text to the page, up to `budget` bytes, and returns its description. */
json_t *report_code_json(struct page *page, const struct html_contents *report, size_t budget);

#endif
