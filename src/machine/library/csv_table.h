/* csv_table.h - a table of text with a first line of column names: RFC 4180, also with semicolons or tabs. */
#ifndef FIVECHECK_MACHINE_LIBRARY_CSV_TABLE_H
#define FIVECHECK_MACHINE_LIBRARY_CSV_TABLE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"

enum { CSV_COLUMNS_MAX = 100, CSV_CELL_MAX = 200 };

/* Initialise it with csv_table_begin. */
struct csv_table {
	const char *next;
	struct srcloc at;	/* the current row */
	struct diag *diag;
	char separator;
	long next_line;
	size_t columns;	/* of the first row; 0 before it is read */
	size_t count;	/* of the cells of the current row */
	char cells[CSV_COLUMNS_MAX][CSV_CELL_MAX + 1];
};

/* Finds the separator in the first line, which may also be Excel's line "sep=;". */
void csv_table_begin(struct csv_table *table, const char *text, const char *path, struct diag *diag);

/*
 * Reads the next row that is not empty. 0: there is none; -1, reported: it is faulty, or it has more cells than the
 * first row.
 */
int csv_table_next(struct csv_table *table);

#endif
