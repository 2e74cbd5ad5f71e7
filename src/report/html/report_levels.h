/*
 * report_levels.h - what of a report grows with the program: path, clearances, planes and the program's text, within
 * its size.
 */
#ifndef FIVECHECK_REPORT_HTML_REPORT_LEVELS_H
#define FIVECHECK_REPORT_HTML_REPORT_LEVELS_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

#include "report/html/html_contents.h"
#include "report/html/page.h"

/*
 * Writes all levels to the page and adds what describes them to the head. `reserved`: bytes that other parts will need.
 * False: a temporary file failed, and the recorder's tables say why.
 */
bool report_levels_write(struct page *page, const struct html_contents *report, json_t *head, size_t reserved);

#endif
