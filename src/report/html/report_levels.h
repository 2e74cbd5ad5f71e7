/*
 * report_levels.h - the parts of a report that grow with the program: path, clearances, planes and the program's text,
 * within the size of the report.
 */
#ifndef FIVECHECK_REPORT_HTML_REPORT_LEVELS_H
#define FIVECHECK_REPORT_HTML_REPORT_LEVELS_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

#include "report/html/html_contents.h"
#include "report/html/page.h"

/*
 * Writes all levels to the page and adds their description to the head. `reserved`: bytes that other parts will need.
 * False: a temporary file failed, and the reason is in the recorder's tables.
 */
bool report_levels_write(struct page *page, const struct html_contents *report, json_t *head, size_t reserved);

#endif
