/* zip_check.h - tests whether a zip archive unpacks to more than may be read. */
#ifndef FIVECHECK_IMPORT_ZIP_CHECK_H
#define FIVECHECK_IMPORT_ZIP_CHECK_H

#include <stdbool.h>

#include "base/diag.h"

/* False, reported: the archive is incomplete, or its files together are larger than FILE_BYTES_MAX. */
bool zip_check(const char *path, struct diag *diag);

#endif
