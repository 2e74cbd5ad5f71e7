/* pack_table.h - columns of whole numbers as the planes of report_data.h, "TABLES". */
#ifndef FIVECHECK_REPORT_HTML_PACK_TABLE_H
#define FIVECHECK_REPORT_HTML_PACK_TABLE_H

#include <stddef.h>
#include <stdint.h>

#include "base/strbuf.h"

/* Appends the table, not deflated. values[row * columns + column]; magnitudes below 2^51; at least one row. */
void pack_table_add(struct strbuf *out, const int64_t *values, size_t rows, size_t columns);

/* Reads the table from the bytes that pack_table_add appended. */
void pack_table_read(int64_t *values, size_t rows, size_t columns, const char *bytes);

#endif
