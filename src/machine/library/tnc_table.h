/*
 * tnc_table.h - tables that TNC controls (Heidenhain) keep as text: a first line "BEGIN TOOL.T MM", a line of column
 * names, one line for each row, and a last line "[END]". A column begins below the first letter of its name.
 */
#ifndef FIVECHECK_MACHINE_LIBRARY_TNC_TABLE_H
#define FIVECHECK_MACHINE_LIBRARY_TNC_TABLE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "machine/library/text_lines.h"

enum { TNC_COLUMNS_MAX = 200 };

struct tnc_column {
	const char *name;	/* in the text, not terminated by a NUL */
	size_t length;
	size_t start;	/* in characters, from 0 */
};

/* Initialise it with tnc_table_begin. */
struct tnc_table {
	struct text_lines lines;	/* at the current row */
	struct srcloc at;	/* the current row */
	struct diag *diag;
	double unit;	/* mm per unit of length; 0: the first line has neither MM nor INCH */
	struct tnc_column columns[TNC_COLUMNS_MAX];
	size_t count;	/* of the columns, in the order of the line */
};

/*
 * Is the text such a table, with columns of all these names (up to a NULL)? Or does its first line name a file with
 * this ending, as in "BEGIN TOOL.T MM"?
 */
bool tnc_table_is(const char *text, const char *const *names, const char *ending);

/* Reads up to the line of column names, which must have all these names. False: reported. */
bool tnc_table_begin(struct tnc_table *table, const char *text, const char *path, const char *const *names,
		     struct diag *diag);

/* Reads the next row that is not empty. 0: the table ends here; -1, reported: it is faulty, or cut off. */
int tnc_table_next(struct tnc_table *table);

/*
 * The text of the current row below a name, without blanks around it, in UTF-8; "" if there is no such column. Bytes
 * that are not UTF-8 are read as Latin-1. False, reported: the text crosses the end of its column, or does not begin
 * below the name.
 */
bool tnc_table_text(const struct tnc_table *table, const char *name, struct strbuf *text);

/* The number there, with a decimal point or comma; NAN: there is none. False, reported: it is no number. */
bool tnc_table_number(const struct tnc_table *table, const char *name, double *value);

#endif
