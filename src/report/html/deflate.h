/* deflate.h - bytes made smaller by zlib, whose memory comes from mem.h. */
#ifndef FIVECHECK_REPORT_HTML_DEFLATE_H
#define FIVECHECK_REPORT_HTML_DEFLATE_H

#include <stddef.h>

#include "base/strbuf.h"

/* Appends the bytes as one zlib stream (RFC 1950). */
void deflate_add(struct strbuf *out, const void *bytes, size_t count);

#endif
