/* file_bytes.h - a whole file in memory. */
#ifndef FIVECHECK_BASE_FILE_BYTES_H
#define FIVECHECK_BASE_FILE_BYTES_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"

struct file_bytes {
	char *bytes;	/* followed by a NUL that `count` does not count; owned */
	size_t count;
};

/* The largest file that is read: larger than any mesh that a machine model needs. */
#define FILE_BYTES_MAX ((size_t)512 * 1024 * 1024)

/* Reads a regular file. False, reported: it is missing, something else, unreadable or too large; *out is untouched. */
bool file_bytes_read(struct file_bytes *out, const char *path, struct diag *diag);
void file_bytes_release(struct file_bytes *file);

#endif
