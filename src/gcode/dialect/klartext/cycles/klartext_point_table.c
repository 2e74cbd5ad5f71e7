#include "gcode/dialect/klartext/cycles/klartext_point_table.h"

#include <math.h>
#include <string.h>

#include "base/same_double.h"
#include "gcode/dialect/klartext/cycles/klartext_points.h"
#include "gcode/dialect/klartext/flow/klartext_folder.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/values/klartext_string.h"
#include "gcode/text/number.h"

/* The largest number of columns of a table. */
#define COLUMNS_MAX 32
/* mm: the largest coordinate ("Point tables", range of input). */
#define COORDINATE_MAX 1e5

enum column { COLUMN_X, COLUMN_Y, COLUMN_Z, COLUMN_FADE, COLUMN_CLEARANCE, COLUMN_OTHER };

/* The line with the names gives the columns: a value begins below its column's name or to the right of it. */
struct table {
	struct interp *interp;
	struct reader *reader;
	struct line_place at;
	double scale; /* mm */
	enum column kind[COLUMNS_MAX];
	size_t start[COLUMNS_MAX];
	int count;
};

static bool next_line(struct table *table)
{
	const char *text;

	if (reader_next(table->reader, &text) != READER_LINE)
		return fault(&table->at, 1, "the point table ends or cannot be read here: its last line is [END]");
	table->at.line = table->reader->line;
	table->at.text = text;
	return !strchr(text, '\t') ||
	       fault(&table->at, (int)(strchr(text, '\t') - text) + 1,
		     "the columns of a point table are told by blanks: a tab hides below which name a value stands");
}

/* Moves *position to the next word and returns its length; 0: there is none. */
static size_t take_word(const char *text, size_t *position)
{
	*position += strspn(text + *position, " \t");
	return strcspn(text + *position, " \t");
}

/* "BEGIN NAME.PNT MM" */
static bool read_unit(struct table *table)
{
	const char *text = table->at.text;
	size_t at = 0, length = take_word(text, &at), last = at, width = length;
	bool begins = length == 5 && !strncmp(text + at, "BEGIN", 5);

	while (length > 0) {
		last = at;
		width = length;
		at += length;
		length = take_word(text, &at);
	}
	if (begins && width == 2 && !strncmp(text + last, "MM", 2))
		table->scale = 1;
	else if (begins && width == 4 && !strncmp(text + last, "INCH", 4))
		table->scale = state_unit(G20);
	else
		return fault(&table->at, 1, "a point table begins with BEGIN, its name, and MM or INCH");
	return true;
}

static enum column kind_of(const char *name, size_t length)
{
	static const char *const names[] = {"X", "Y", "Z", "FADE", "CLEARANCE"};

	for (int i = COLUMN_X; i < COLUMN_OTHER; i++) {
		if (strlen(names[i]) == length && !strncmp(name, names[i], length))
			return (enum column)i;
	}
	return COLUMN_OTHER;
}

static bool read_names(struct table *table)
{
	const char *text = table->at.text;
	bool has[COLUMN_OTHER + 1] = {false};
	size_t at = 0, length;

	for (; (length = take_word(text, &at)) > 0; at += length) {
		if (table->count == COLUMNS_MAX)
			return fault(&table->at, (int)at + 1, "a point table has at most %d columns", COLUMNS_MAX);
		table->kind[table->count] = kind_of(text + at, length);
		table->start[table->count] = at;
		if (has[table->kind[table->count]] && table->kind[table->count] != COLUMN_OTHER)
			return fault(&table->at, (int)at + 1, "this column stands twice in the point table");
		has[table->kind[table->count++]] = true;
	}
	return (has[COLUMN_X] && has[COLUMN_Y]) ||
	       fault(&table->at, 1, "the second line of a point table names its columns: X and Y are missing");
}

/* Finds the column that contains the whole word at `at`. False: reported. */
static bool find_column(struct table *table, size_t at, size_t length, int *found)
{
	int i = 0;

	while (i + 1 < table->count && table->start[i + 1] <= at)
		i++;
	if (at < table->start[i] || (i + 1 < table->count && at + length > table->start[i + 1]))
		return fault(&table->at, (int)at + 1, "the value does not stand below the name of one column");
	*found = i;
	return true;
}

static bool read_value(struct table *table, size_t at, size_t length, double *value)
{
	size_t position = at;

	if (number_read_with_comma(table->at.text, &position, value) != NUMBER_OK || position != at + length)
		return fault(&table->at, (int)at + 1, "a number is needed here");
	*value *= table->scale;
	return fabs(*value) < COORDINATE_MAX ||
	       fault(&table->at, (int)at + 1, "a coordinate is less than %g mm", COORDINATE_MAX);
}

/* Reads a line of values. The control leaves out a point that FADE hides. */
static bool read_row(struct table *table)
{
	const char *text = table->at.text;
	double value[3] = {0, 0, 0};
	bool has[COLUMN_OTHER + 1] = {false}, hidden = false;
	size_t at = 0, length;
	int i, before = -1;

	for (; (length = take_word(text, &at)) > 0; at += length) {
		if (!find_column(table, at, length, &i))
			return false;
		/* The text of a column that is not read may contain blanks. */
		if (i == before && (table->kind[i] != COLUMN_OTHER || i == 0))
			return fault(&table->at, (int)at + 1, "two values stand below the name of one column");
		before = i;
		if (table->kind[i] <= COLUMN_Z && !read_value(table, at, length, &value[table->kind[i]]))
			return false;
		if (table->kind[i] == COLUMN_CLEARANCE)
			return fault(&table->at, (int)at + 1,
				     "a clearance height of a single point (CLEARANCE) is not supported: take it "
				     "out, and the cycle's Q204 counts");
		if (table->kind[i] == COLUMN_FADE && length == 1 && (text[at] == 'Y' || text[at] == 'N'))
			hidden = text[at] == 'Y';
		else if (table->kind[i] == COLUMN_FADE)
			return fault(&table->at, (int)at + 1, "FADE is Y or N");
		has[table->kind[i]] = true;
	}
	if (hidden)
		return true;
	if (!has[COLUMN_X] || !has[COLUMN_Y])
		return fault(&table->at, 1, "a point needs values in X and Y");
	klartext_of(table->interp)->points.surface |= !same_double(value[2], 0);
	return klartext_points_add(table->interp, (int)at + 1, (vec3){value[0], value[1], value[2]});
}

/*
 * iTNC 530 user's manual, "Point tables": BEGIN, the names of the columns, the points, [END]. Z is the surface of the
 * workpiece if Q203 of the cycle is 0.
 */
static bool read_table(struct table *table)
{
	if (!next_line(table) || !read_unit(table) || !next_line(table) || !read_names(table))
		return false;
	for (;;) {
		if (!next_line(table))
			return false;
		if (!strncmp(table->at.text, "[END]", 5))
			return true;
		if (table->at.text[strspn(table->at.text, " \t")] != '\0' && !read_row(table))
			return false;
	}
}

bool klartext_point_table_select(struct lexer *lexer)
{
	static const char *const endings[] = {"", ".pnt", ".PNT"};
	struct interp *interp = lexer->context;
	const int column = lexer_next_column(lexer);
	struct table table = {.interp = interp};
	struct source *source;
	char name[KLARTEXT_NAME];

	if (!klartext_string_name(lexer, "a point table's name", name) || !klartext_expect_end(lexer) ||
	    !klartext_folder_find(interp, name, endings, column, &source))
		return false;
	if (!source || source == interp->program.source)
		return fault(lexer->at, column, "there is no file of the point table %s", name);
	table.reader = &source->reader;
	table.at = (struct line_place){.diag = interp->diag, .file = source->name, .line = 1, .text = ""};
	klartext_points_begin(interp);
	klartext_of(interp)->points.line = 0;
	return reader_seek(table.reader, 0, 1)
		   ? read_table(&table)
		   : fault(lexer->at, column, "the point table %s cannot be read again", name);
}
