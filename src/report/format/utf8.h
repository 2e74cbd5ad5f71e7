/* utf8.h - names and blocks may hold any bytes; reports in JSON and XML may not. */
#ifndef FIVECHECK_REPORT_FORMAT_UTF8_H
#define FIVECHECK_REPORT_FORMAT_UTF8_H

#include <stddef.h>

#include "base/strbuf.h"

/* How many bytes the UTF-8 sequence at `text` takes (RFC 3629); 0 if it is none, or at the end of the text. */
size_t utf8_length(const char *text);

/* Appends the text with U+FFFD in the place of each byte that is no UTF-8. */
void utf8_add_clean(struct strbuf *out, const char *text);

/* How long the cleaned text is in UTF-16 code units, in which SARIF counts columns. */
size_t utf8_units(const char *text);

#endif
