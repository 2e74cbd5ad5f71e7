#include "machine/library/tnc_table.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "base/decimal.h"
#include "base/units.h"
#include "base/utf8.h"

/* The line of column names is among the first lines: before it, only comments and a description of the columns. */
enum { HEAD_LINES_MAX = 1000 };

/* The largest number of a table (TNC7 user's manual, "Tool table tool.t": input -99999.9999 to 99999.9999). */
#define NUMBER_MAX 99999.9999

static bool fault(const struct tnc_table *table, const char *what)
{
	diag_error(table->diag, table->at, "%s", what);
	return false;
}

/* --------------------------------------------------------------------- head */

/* The next word of the line at *at, which moves past it; its length, or 0: there is none. */
static size_t next_word(const char **at, const char *end, const char **word)
{
	while (*at < end && ascii_is_space(**at))
		++*at;
	*word = *at;
	while (*at < end && !ascii_is_space(**at))
		++*at;
	return (size_t)(*at - *word);
}

static bool is_word(const char *word, size_t length, const char *name)
{
	return strlen(name) == length && ascii_same_start(word, name, length);
}

/* Advances to a line with content. */
static bool next_line(struct text_lines *lines)
{
	while (text_lines_next(lines))
		for (size_t i = 0; i < lines->length; i++)
			if (!ascii_is_space(lines->line[i]))
				return true;
	return false;
}

/* "BEGIN TOOL .T MM", but not the first line of a program, "BEGIN PGM ...". *unit: as in struct tnc_table. */
static bool is_first_line(const struct text_lines *lines, double *unit)
{
	const char *at = lines->line, *end = lines->line + lines->length, *word;
	size_t length = next_word(&at, end, &word);

	*unit = 0;
	if (!is_word(word, length, "BEGIN"))
		return false;
	length = next_word(&at, end, &word);
	if (!length || is_word(word, length, "PGM"))
		return false;
	while ((length = next_word(&at, end, &word)) > 0) {
		if (is_word(word, length, "MM"))
			*unit = 1;
		else if (is_word(word, length, "INCH"))
			*unit = MM_PER_INCH;
	}
	return true;
}

static const struct tnc_column *find_column(const struct tnc_table *table, const char *name)
{
	for (size_t i = 0; i < table->count; i++)
		if (is_word(table->columns[i].name, table->columns[i].length, name))
			return &table->columns[i];
	return NULL;
}

/* Reads the current line as column names. Does it have all that are needed? */
static bool read_names(struct tnc_table *table, const char *const *names)
{
	const char *at = table->lines.line, *end = at + table->lines.length, *word;
	size_t length;

	table->count = 0;
	while (table->count < TNC_COLUMNS_MAX && (length = next_word(&at, end, &word)) > 0)
		table->columns[table->count++] =
			(struct tnc_column){word, length, (size_t)(word - table->lines.line)};
	for (; *names; names++)
		if (!find_column(table, *names))
			return false;
	return true;
}

static bool find_names(struct tnc_table *table, const char *const *names)
{
	if (!next_line(&table->lines) || !is_first_line(&table->lines, &table->unit))
		return false;
	while (next_line(&table->lines) && table->lines.number <= HEAD_LINES_MAX)
		if (read_names(table, names))
			return true;
	return false;
}

/* Is this a first line with a word that has the ending? */
static bool names_file(const char *text, const char *ending)
{
	struct text_lines lines = {.next = text};
	const char *at, *end, *word;
	const size_t ending_length = strlen(ending);
	size_t length;
	double unit;

	if (!next_line(&lines) || !is_first_line(&lines, &unit))
		return false;
	at = lines.line;
	end = at + lines.length;
	while ((length = next_word(&at, end, &word)) > 0)
		if (length >= ending_length && is_word(word + length - ending_length, ending_length, ending))
			return true;
	return false;
}

bool tnc_table_is(const char *text, const char *const *names, const char *ending)
{
	struct tnc_table table = {.lines = {.next = text}};

	return names_file(text, ending) || find_names(&table, names);
}

static void report_names(const struct tnc_table *table, const char *const *names)
{
	struct strbuf list = {0};

	for (; *names; names++)
		strbuf_addf(&list, "%s%s", list.length ? ", " : "", *names);
	diag_error(table->diag, table->at,
		   "the table has no line with the names of its columns, which must have %s: take the file as the "
		   "control writes it",
		   strbuf_text(&list));
	strbuf_release(&list);
}

bool tnc_table_begin(struct tnc_table *table, const char *text, const char *path, const char *const *names,
		     struct diag *diag)
{
	*table = (struct tnc_table){.lines = {.next = text}, .at = {.file = path}, .diag = diag};
	if (!find_names(table, names)) {
		report_names(table, names);
		return false;
	}
	table->at.line = table->lines.number;
	if (memchr(table->lines.line, '\t', table->lines.length))
		return fault(table,
			     "the line of column names has tabs, so the positions of the columns are not known: take "
			     "the file as the control writes it");
	for (size_t i = 0; i < table->count; i++)
		for (size_t k = 0; k < i; k++)
			if (table->columns[i].length == table->columns[k].length &&
			    ascii_same_start(table->columns[i].name, table->columns[k].name,
					     table->columns[i].length)) {
				diag_error(diag, table->at, "two columns have the name %.*s",
					   (int)table->columns[i].length, table->columns[i].name);
				return false;
			}
	return true;
}

/* --------------------------------------------------------------------- rows */

static bool is_end(const struct text_lines *lines)
{
	const char *at = lines->line, *word;
	const size_t length = next_word(&at, lines->line + lines->length, &word);

	return is_word(word, length, "[END]");
}

static int stop(const struct tnc_table *table, const char *what)
{
	fault(table, what);
	return -1;
}

int tnc_table_next(struct tnc_table *table)
{
	while (next_line(&table->lines)) {
		table->at.line = table->lines.number;
		if (is_end(&table->lines)) {
			if (!next_line(&table->lines))
				return 0;
			table->at.line = table->lines.number;
			return stop(table, "the table ends with [END], but the file goes on");
		}
		if (memchr(table->lines.line, '\t', table->lines.length))
			return stop(table,
				    "the row has tabs, so the positions of its cells are not known: take the file as "
				    "the control writes it");
		if (table->lines.line[0] != ';')
			return 1;
	}
	return stop(table, "the table is cut off: its last line [END] is missing");
}

/* The bytes of the character at a place of the line: of UTF-8, or one byte of Latin-1. */
static size_t character_bytes(const char *at)
{
	const size_t length = utf8_length(at);

	return length ? length : 1;
}

/* The place of a character of the current row, or the end of the row. */
static const char *place_of(const struct tnc_table *table, size_t index)
{
	const char *at = table->lines.line, *end = at + table->lines.length;

	while (index-- && at < end)
		at += character_bytes(at);
	return at < end ? at : end;
}

/* Appends the bytes as UTF-8. */
static void add_text(struct strbuf *text, const char *at, const char *end)
{
	while (at < end) {
		const size_t length = utf8_length(at);
		const unsigned char byte = (unsigned char)*at;

		if (length && byte)
			strbuf_add(text, at, length);
		else
			strbuf_addf(text, "%c%c", 0xc0 | byte >> 6, 0x80 | (byte & 0x3f));
		at += length ? length : 1;
	}
}

/*
 * Do two cells touch where the second begins? A name may fill its column, and a number has a sign then. Otherwise the
 * row has slipped against the line of column names, and a cell would lose digits.
 */
static bool is_cut(const struct tnc_table *table, const char *at)
{
	const char *line = table->lines.line, *end = line + table->lines.length;

	return at > line && at < end && at[-1] != ' ' && *at != ' ' && *at != '+' && *at != '-' && *at != '%';
}

bool tnc_table_text(const struct tnc_table *table, const char *name, struct strbuf *text)
{
	const struct tnc_column *column = find_column(table, name);
	const char *from, *to, *text_from;

	strbuf_clear(text);
	if (!column)
		return true;
	from = place_of(table, column->start);
	to = column + 1 < table->columns + table->count ? place_of(table, column[1].start)
							 : table->lines.line + table->lines.length;
	for (text_from = from; text_from < to && *text_from == ' ';)
		text_from++;
	/* The control begins each text at the left. */
	if (is_cut(table, from) || is_cut(table, to) || (text_from < to && text_from > from)) {
		diag_error(table->diag, table->at,
			   "the text of %s does not begin below its name: the row has slipped against the line of "
			   "column names",
			   name);
		return false;
	}
	while (to > from && to[-1] == ' ')
		to--;
	add_text(text, from, to);
	return true;
}

static bool read_number(const struct strbuf *text, double *value)
{
	char word[32];
	char *comma;

	if (text->length >= sizeof(word))
		return false;
	strcpy(word, strbuf_text(text));
	comma = strchr(word, ',');
	if (comma && !strchr(word, '.'))
		*comma = '.';
	return decimal_read(word, strlen(word), value) && fabs(*value) <= NUMBER_MAX;
}

bool tnc_table_number(const struct tnc_table *table, const char *name, double *value)
{
	struct strbuf text = {0};
	bool good = tnc_table_text(table, name, &text);

	*value = NAN;
	if (good && text.length && !read_number(&text, value)) {
		good = false;
		*value = NAN;
		diag_error(table->diag, table->at, "%s must be a number of at most 99999.9999, not '%.40s'", name,
			   strbuf_text(&text));
	}
	strbuf_release(&text);
	return good;
}
