/* file_signature.h - tells by the first bytes of a file that it is packed, a document or in UTF-16 or UTF-32. */
#ifndef FIVECHECK_BASE_FILE_SIGNATURE_H
#define FIVECHECK_BASE_FILE_SIGNATURE_H

#include <stddef.h>

/*
 * What the file is, and what to do: "this file is packed by gzip: unpack it first"; NULL: it begins like no such file.
 * Eight bytes tell all.
 */
const char *file_signature_advice(const char *bytes, size_t length);

#endif
