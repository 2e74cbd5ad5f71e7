#include "machine/library/csv_table.h"

#include <string.h>

void csv_table_begin(struct csv_table *table, const char *text, const char *path, struct diag *diag)
{
	size_t length, tabs = 0, semicolons = 0;

	if (!strncmp(text, "\xef\xbb\xbf", 3))
		text += 3;
	length = strcspn(text, "\r\n");
	for (size_t i = 0; i < length; i++) {
		tabs += text[i] == '\t';
		semicolons += text[i] == ';';
	}
	table->next = text;
	table->at = (struct srcloc){.file = path};
	table->diag = diag;
	table->separator = ',';
	if (tabs)
		table->separator = '\t';
	else if (semicolons)
		table->separator = ';';
	table->next_line = 1;
	table->count = 0;
}

static bool fault(const struct csv_table *table, const char *what)
{
	diag_error(table->diag, table->at, "%s", what);
	return false;
}

/* Puts a character into the current cell. */
static bool put(const struct csv_table *table, char *cell, size_t *length, char c)
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
		if (!put(table, cell, &length, *table->next))
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
		if (!put(table, cell, &length, *table->next))
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
		table->next += *table->next == '\r';
		table->next_line += *table->next == '\n';
		table->next += *table->next == '\n';
		if (!is_blank(table))
			return 1;
	}
	return 0;
}
