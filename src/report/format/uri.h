/* uri.h - writes the name of a file as a URI reference. */
#ifndef FIVECHECK_REPORT_FORMAT_URI_H
#define FIVECHECK_REPORT_FORMAT_URI_H

#include "base/strbuf.h"

/*
 * Appends a relative reference (RFC 3986, section 4.2) if the path is below the current folder, otherwise a file: URI.
 * All bytes but the unreserved characters are percent-encoded.
 */
void uri_add(struct strbuf *out, const char *path);

#endif
