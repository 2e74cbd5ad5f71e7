/* html_text.h - any text as text of an HTML page. */
#ifndef FIVECHECK_REPORT_FORMAT_HTML_TEXT_H
#define FIVECHECK_REPORT_FORMAT_HTML_TEXT_H

#include <jansson.h>

#include "base/strbuf.h"

/*
 * Appends the text, valid as element content, as a quoted attribute, and in SVG. Control characters become spaces.
 * NULL adds nothing.
 */
void html_text_add(struct strbuf *out, const char *text);

/* Appends the value as JSON that is valid inside <script>: it contains no <. */
void html_text_add_json(struct strbuf *out, const json_t *value);

#endif
