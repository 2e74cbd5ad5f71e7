/* stock_file.h - writes the stock that a program leaves as an STL file (--stock-out). */
#ifndef FIVECHECK_REPORT_STOCK_FILE_H
#define FIVECHECK_REPORT_STOCK_FILE_H

#include <stdbool.h>

#include "base/diag.h"
#include "stock/stock_mesh.h"

/*
 * Says in a note how exact the file is, or why there is none. `stock`: the setup has one. False, reported: the file is
 * as it was.
 */
bool stock_file_write(const char *path, const struct stock_remainder *remainder, bool stock, struct diag *diag);

#endif
