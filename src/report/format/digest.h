/* digest.h - SHA-256 of files and texts, as hexadecimal digits. */
#ifndef FIVECHECK_REPORT_FORMAT_DIGEST_H
#define FIVECHECK_REPORT_FORMAT_DIGEST_H

#include <stdbool.h>
#include <stddef.h>

#include "base/callbacks.h"

/* 64 digits and the terminating NUL. */
enum { DIGEST_SIZE = 65 };

void digest_bytes(char digest[DIGEST_SIZE], const char *bytes, size_t count);

/* False: the file could not be read (see errno), or `cancel` (or NULL) requests a stop: ECANCELED. */
bool digest_file(char digest[DIGEST_SIZE], const char *path, const struct cancel *cancel);

#endif
