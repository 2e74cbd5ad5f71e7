/* utf8.h - makes valid UTF-8 of names and blocks, which may contain any bytes. */
#ifndef FIVECHECK_BASE_UTF8_H
#define FIVECHECK_BASE_UTF8_H

#include <stddef.h>

#include "base/strbuf.h"

/* The number of bytes of the UTF-8 sequence at `text` (RFC 3629); 0: not UTF-8, or the end of the text. */
size_t utf8_length(const char *text);

/* Appends the text; each byte that is not UTF-8 becomes U+FFFD. */
void utf8_add_clean(struct strbuf *out, const char *text);

/* The length of the cleaned text in UTF-16 code units, in which SARIF counts columns. */
size_t utf8_units(const char *text);

#endif
