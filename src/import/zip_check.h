/* zip_check.h - tells whether a zip archive unpacks to more than is read. */
#ifndef FIVECHECK_IMPORT_ZIP_CHECK_H
#define FIVECHECK_IMPORT_ZIP_CHECK_H

#include <stdbool.h>

#include "base/diag.h"

/* False, reported: the archive is not whole, or its files together are larger than FILE_BYTES_MAX. */
bool zip_check(const char *path, struct diag *diag);

#endif
