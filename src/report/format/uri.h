/* uri.h - a file's name as a URI reference. */
#ifndef FIVECHECK_REPORT_FORMAT_URI_H
#define FIVECHECK_REPORT_FORMAT_URI_H

#include "base/strbuf.h"

/*
 * Appends the path as a relative reference (RFC 3986, section 4.2): relative
 * to the current folder if it is below it, else as a file: URI. Bytes beyond
 * the unreserved characters are percent-encoded.
 */
void uri_add(struct strbuf *out, const char *path);

#endif
