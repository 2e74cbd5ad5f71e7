/* stock_file.h - writes the stock that remains after a program as an STL file (--stock-out). */
#ifndef FIVECHECK_REPORT_STOCK_FILE_H
#define FIVECHECK_REPORT_STOCK_FILE_H

#include <stdbool.h>

#include "base/diag.h"
#include "stock/stock_mesh.h"

/* A note gives the accuracy of the file, or the reason why there is none. False, reported: the file is not changed. */
bool stock_file_write(const char *path, const struct stock_remainder *remainder, struct diag *diag);

#endif
