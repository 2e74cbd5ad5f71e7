/* base64.h - base64 (RFC 4648) without line breaks. */
#ifndef FIVECHECK_REPORT_FORMAT_BASE64_H
#define FIVECHECK_REPORT_FORMAT_BASE64_H

#include <stddef.h>

#include "base/strbuf.h"

/* Appends the code of the bytes, padded with = to a multiple of four characters. */
void base64_add(struct strbuf *out, const unsigned char *bytes, size_t count);

#endif
