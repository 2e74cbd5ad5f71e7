/* file_bytes.h - a whole file in memory. */
#ifndef FIVECHECK_BASE_FILE_BYTES_H
#define FIVECHECK_BASE_FILE_BYTES_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"

struct file_bytes {
	char *bytes;	/* followed by a NUL that is not counted; owned */
	size_t count;
};

/* The largest file that is read: larger than any mesh of a machine model. */
#define FILE_BYTES_MAX ((size_t)512 * 1024 * 1024)

/* Reads a regular file. False, reported: it is missing, not regular, unreadable or too large; *out is unchanged. */
bool file_bytes_read(struct file_bytes *out, const char *path, struct diag *diag);
void file_bytes_release(struct file_bytes *file);

#endif
