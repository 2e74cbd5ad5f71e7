/* ply_check.h - is a PLY file complete? The library that reads it fills in missing data. */
#ifndef FIVECHECK_IMPORT_PLY_CHECK_H
#define FIVECHECK_IMPORT_PLY_CHECK_H

#include <stdbool.h>

#include "base/diag.h"

/* Does the file have as many elements as its header says? False: reported. */
bool ply_check(const char *path, struct diag *diag);

#endif
