/* plain_html.h - the part of a report that is visible without JavaScript: verdict, findings, picture, files. */
#ifndef FIVECHECK_REPORT_HTML_PLAIN_HTML_H
#define FIVECHECK_REPORT_HTML_PLAIN_HTML_H

#include "base/strbuf.h"
#include "report/html/html_contents.h"

/* Appends everything up to <body>: the policy permits one style and, by their hashes, the scripts (NULL: none). */
void plain_html_add_head(struct strbuf *out, const char *title, bool scripts);

/* Appends the element <main id="plain">. */
void plain_html_add_main(struct strbuf *out, const struct html_contents *report);

/* Rows with a name and a text about the check, for people. */
json_t *plain_html_statistics(const struct html_contents *report);

#endif
