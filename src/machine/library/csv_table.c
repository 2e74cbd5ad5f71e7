#include "machine/library/csv_table.h"

#include <string.h>

#include "base/ascii.h"

/* Moves past the end of a line: LF, CR LF, or CR. */
static void skip_line_end(struct csv_table *table)
{
	if (!*table->next)
		return;
	table->next += *table->next == '\r' && table->next[1] == '\n';
	table->next++;
	table->next_line++;
}

/* The separator that occurs in the first line. */
static char find_separator(const char *text)
{
	const size_t length = strcspn(text, "\r\n");

	if (memchr(text, '\t', length))
		return '\t';
	return memchr(text, ';', length) ? ';' : ',';
}

/* Excel reads and writes a line "sep=;" before the column names. */
static bool is_separator_line(const char *line)
{
	return ascii_same_start(line, "sep=", 4) && line[4] && strchr(",;\t", line[4]) && line[5] &&
	       strchr("\r\n", line[5]);
}

void csv_table_begin(struct csv_table *table, const char *text, const char *path, struct diag *diag)
{
	if (!strncmp(text, "\xef\xbb\xbf", 3))
		text += 3;
	table->next = text;
	table->at = (struct srcloc){.file = path};
	table->diag = diag;
	table->next_line = 1;
	table->columns = table->count = 0;
	table->separator = find_separator(text);
	if (!is_separator_line(text))
		return;
	table->separator = text[4];
	table->next += 5;
	skip_line_end(table);
}

static bool fault(const struct csv_table *table, const char *what)
{
	diag_error(table->diag, table->at, "%s", what);
	return false;
}

/* Puts a character into the current cell. */
static bool add_to_cell(const struct csv_table *table, char *cell, size_t *length, char c)
{
	if (*length == CSV_CELL_MAX)
		return fault(table, "a cell of the table is longer than 200 bytes");
	cell[(*length)++] = (unsigned char)c < 0x20 ? ' ' : c;
	cell[*length] = '\0';
	return true;
}

/* Reads a cell in quotation marks, which may contain separators, line ends and doubled marks. */
static bool read_quoted(struct csv_table *table, char *cell)
{
	size_t length = 0;

	for (table->next++; *table->next; table->next++) {
		if (*table->next == '"' && *++table->next != '"')
			return true;
		table->next_line += *table->next == '\n';
		if (!add_to_cell(table, cell, &length, *table->next))
			return false;
	}
	return fault(table, "a quotation mark is not closed");
}

static void trim(char *cell)
{
	size_t length = strlen(cell), blanks = strspn(cell, " ");

	while (length > blanks && cell[length - 1] == ' ')
		cell[--length] = '\0';
	memmove(cell, cell + blanks, length - blanks + 1);
}

static bool read_cell(struct csv_table *table)
{
	char *cell;
	size_t length = 0;

	if (table->count == CSV_COLUMNS_MAX)
		return fault(table, "more than 100 columns");
	cell = table->cells[table->count++];
	cell[0] = '\0';
	table->next += strspn(table->next, " ");
	if (*table->next == '"' && !read_quoted(table, cell))
		return false;
	length = strlen(cell);
	for (; *table->next && !strchr("\r\n", *table->next) && *table->next != table->separator; table->next++)
		if (!add_to_cell(table, cell, &length, *table->next))
			return false;
	trim(cell);
	return true;
}

static bool is_blank(const struct csv_table *table)
{
	for (size_t i = 0; i < table->count; i++)
		if (table->cells[i][0])
			return false;
	return true;
}

/* Without this, a decimal comma between commas would shift the cells of its row. */
static bool fits_columns(const struct csv_table *table)
{
	for (size_t i = table->columns; table->columns && i < table->count; i++)
		if (table->cells[i][0])
			return fault(table, table->separator == ','
						? "the row has more cells than the table has columns; a table with "
						  "decimal commas needs semicolons between its cells"
						: "the row has more cells than the table has columns");
	return true;
}

int csv_table_next(struct csv_table *table)
{
	while (*table->next) {
		table->at.line = table->next_line;
		table->count = 0;
		do {
			table->next += table->count > 0;
			if (!read_cell(table))
				return -1;
		} while (*table->next == table->separator);
		skip_line_end(table);
		if (is_blank(table))
			continue;
		if (!fits_columns(table))
			return -1;
		if (!table->columns)
			table->columns = table->count;
		return 1;
	}
	return 0;
}
