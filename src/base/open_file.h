/* open_file.h - opens a file that the user has named. */
#ifndef FIVECHECK_BASE_OPEN_FILE_H
#define FIVECHECK_BASE_OPEN_FILE_H

#include <stdio.h>

#include "base/diag.h"

/* Opens a file, or a FIFO, for reading. NULL, reported: it is missing, unreadable, or a directory. */
FILE *open_file(const char *path, struct diag *diag);

#endif
