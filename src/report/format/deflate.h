/* deflate.h - compresses bytes with zlib, whose memory comes from mem.h. */
#ifndef FIVECHECK_REPORT_FORMAT_DEFLATE_H
#define FIVECHECK_REPORT_FORMAT_DEFLATE_H

#include <stddef.h>

#include "base/strbuf.h"

/* DEFLATE_FAST for long data: a fifth larger, several times as fast. */
enum deflate_level { DEFLATE_FAST = 1, DEFLATE_SMALL = 9 };

/* Appends the bytes as one zlib stream (RFC 1950). */
void deflate_add(struct strbuf *out, const void *bytes, size_t count, enum deflate_level level);

#endif
