/* file_signature.h - recognises packed files, documents, UTF-16 and UTF-32 by the first bytes of a file. */
#ifndef FIVECHECK_BASE_FILE_SIGNATURE_H
#define FIVECHECK_BASE_FILE_SIGNATURE_H

#include <stddef.h>

/*
 * What the file is, and what to do: "this file is packed by gzip: unpack it first"; NULL: no such file. Eight bytes are
 * enough.
 */
const char *file_signature_advice(const char *bytes, size_t length);

#endif
