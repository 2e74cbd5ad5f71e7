/* xml_text.h - text for XML that is written without a library. */
#ifndef FIVECHECK_BASE_XML_TEXT_H
#define FIVECHECK_BASE_XML_TEXT_H

#include "base/strbuf.h"

/*
 * Texts may contain any bytes: a control character becomes a question mark, a byte that is not UTF-8 U+FFFD. Appends
 * ` name="value"`, escaped.
 */
void xml_text_attribute(struct strbuf *out, const char *name, const char *value);

/* Appends a line with a comment, whose text cannot end it. */
void xml_text_comment(struct strbuf *out, const char *text);

#endif
