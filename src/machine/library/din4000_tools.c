#include "machine/library/din4000_tools.h"

#include <math.h>
#include <string.h>

#include "base/decimal.h"
#include "machine/library/catalog_tool.h"
#include "machine/library/csv_table.h"
#include "machine/xml/foreign_xml.h"
#include "machine/xml/xml_element.h"

/* More codes than a tool has; and the levels of elements between a tool and its codes. */
enum { CODES_MAX = 400, DEPTH_MAX = 8 };

/* The values of one tool. */
struct record {
	struct srcloc at;
	size_t count;
	const char *codes[CODES_MAX], *values[CODES_MAX];
	bool doubtful;	/* a size has two values, or there are more codes than a tool has */
};

static const char *value_of(const struct record *record, const char *code)
{
	for (size_t i = 0; i < record->count; i++)
		if (!strcmp(record->codes[i], code))
			return record->values[i];
	return "";
}

/* The first value of a code is used. Different names (J) are permitted, different sizes are not. */
static void note_code(struct record *record, const char *code, const char *value)
{
	const char *before = value_of(record, code);

	if (!*code || !*value || !strcmp(before, value))
		return;
	if (*before || record->count == CODES_MAX) {
		record->doubtful |= *code != 'J';
		return;
	}
	record->codes[record->count] = code;
	record->values[record->count++] = value;
}

/* ------------------------------------------------------------------ one tool */

static const struct {
	const char *nsm, *bld;
	enum catalog_shape shape;
} classes[] = {
	{"DIN4000-82", "1", CATALOG_MILL},
	{"DIN4000-82", "2", CATALOG_MILL},
	{"DIN4000-82", "6", CATALOG_BALL_MILL},
	{"DIN4000-81", "1", CATALOG_DRILL},
};

/* Codes of shapes that do not belong to these classes: profiles, steps, threads, inserts. */
static const char *const strange_codes[] = {"G5", "G6", "A11_2", "B2_2", "D31", "D32"};

/* A number with a decimal point or comma. False: it is not a number. */
static bool read_number(const char *text, double *value)
{
	char number[40];
	char *comma;

	*value = NAN;
	if (!*text)
		return true;
	if (strlen(text) >= sizeof(number))
		return false;
	strcpy(number, text);
	comma = strchr(number, ',');
	if (comma && !strchr(number, '.'))
		*comma = '.';
	return decimal_read(number, strlen(number), value) && isfinite(*value);
}

/* The size is that of the first code with a value above 0. */
static const char *read_size(const struct record *record, const char *const codes[3], double *size)
{
	static const char not_a_number[] = "a dimension is not a number";

	for (int i = 0; i < 3 && codes[i]; i++) {
		double value;

		if (!read_number(value_of(record, codes[i]), &value))
			return not_a_number;
		if (value < 0)
			return "a dimension is negative";
		if (value > 0) {
			*size = value;
			break;
		}
	}
	return NULL;
}

/* Why the sizes cannot be used; NULL: they are read. */
static const char *read_sizes(const struct record *record, struct catalog_tool *tool)
{
	const bool drill = tool->shape == CATALOG_DRILL;
	const struct {
		double *size;
		const char *codes[3];
	} rows[] = {
		{&tool->diameter, {drill ? "A11" : "A1"}},
		{&tool->overall_length, {"B5"}},
		/* B6 is the length of the flutes. */
		{&tool->cutting_length, {drill ? "B6" : "B2", drill ? "B4" : "B6"}},
		{&tool->corner_radius, {drill ? NULL : "G1", drill ? NULL : "G4"}},
		{&tool->chamfer_width, {drill ? NULL : "G2"}},
		{&tool->chamfer_angle, {drill ? NULL : "G3"}},
		{&tool->point_angle, {drill ? "E1" : NULL}},
		{&tool->neck_diameter, {drill ? NULL : "A5"}},
		{&tool->neck_end, {drill ? NULL : "B9"}},
		{&tool->shank_diameter, {"C3"}},
		{&tool->shank_length, {"C4"}},
	};
	const char *why = record->doubtful ? "a code has two values, or there are too many codes" : NULL;

	for (size_t i = 0; !why && i < sizeof(rows) / sizeof(*rows); i++)
		why = read_size(record, rows[i].codes, rows[i].size);
	for (size_t i = 0; !why && i < sizeof(strange_codes) / sizeof(*strange_codes); i++) {
		const char *text = value_of(record, strange_codes[i]);
		double value;

		if (*text && (!read_number(text, &value) || fabs(value) > 0))
			why = "the tool has a profile, a step or a thread";
	}
	return why;
}

/* Is this the name of the class? Blanks do not matter. */
static bool is_class(const char *text, const char *name)
{
	for (; *text; text++) {
		if (*text == ' ')
			continue;
		if (*text != *name++)
			return false;
	}
	return !*name;
}

static bool add_tool(struct tool_library *tools, const struct record *record, struct diag *diag)
{
	const char *nsm = value_of(record, "NSM"), *bld = value_of(record, "BLD"), *name = value_of(record, "J23");
	struct catalog_tool tool = catalog_tool_empty(record->at);
	const char *why = "the class is none of DIN 4000-82, pictures 1, 2 and 6 (mills), and DIN 4000-81, picture 1 "
			  "(drills)";

	tool.name = *name ? name : *value_of(record, "J22") ? value_of(record, "J22") : value_of(record, "J21");
	bld += *bld == '0';
	for (size_t i = 0; i < sizeof(classes) / sizeof(*classes); i++) {
		if (!is_class(nsm, classes[i].nsm) || strcmp(bld, classes[i].bld) != 0)
			continue;
		tool.shape = classes[i].shape;
		why = read_sizes(record, &tool);
	}
	if (!why)
		return catalog_tool_add(tools, &tool, diag);
	catalog_tool_leave_out(tools, &tool, why, diag);
	return true;
}

/* ----------------------------------------------------------------------- XML */

struct reading {
	struct tool_library *tools;
	struct xml_reader xml;
	struct arena arena;	/* the texts of one tool */
};

/* <PropertyName source="din_mk">A1</PropertyName><Value>12</Value> */
static void read_code(struct reading *r, const xmlNode *node, struct record *record)
{
	const xmlNode *name = foreign_child(node, "PropertyName");

	/* Another standard may describe the same tool, too. */
	while (name && foreign_attribute(name, "source") && !foreign_attribute_is(name, "source", "din_mk"))
		name = foreign_next(name, "PropertyName");
	if (name)
		note_code(record, foreign_text(&r->arena, name), foreign_text(&r->arena, foreign_child(node, "Value")));
}

/* Reads all codes below the element. */
static void read_codes(struct reading *r, const xmlNode *parent, struct record *record, int depth)
{
	for (const xmlNode *at = foreign_child(parent, NULL); at && depth < DEPTH_MAX; at = foreign_next(at, NULL)) {
		if (foreign_is(at, "Property-Data") || foreign_is(at, "Category-Data"))
			read_code(r, at, record);
		else
			read_codes(r, at, record, depth + 1);
	}
}

static bool read_xml(struct reading *r)
{
	const xmlNode *root = xml_root(&r->xml);
	bool good = true;

	for (const xmlNode *at = foreign_child(root, "Tool"); good && at; at = foreign_next(at, "Tool")) {
		struct record record = {.at = {.file = r->xml.path, .line = xml_line(&r->xml, at)}};

		read_codes(r, at, &record, 0);
		good = add_tool(r->tools, &record, r->xml.diag);
		arena_release(&r->arena);
	}
	if (good && !foreign_child(root, "Tool"))
		xml_error(&r->xml, root, NULL, "the file has no <Tool>");
	return good && !r->xml.errors;
}

bool din4000_xml_read(struct tool_library *tools, const char *path, struct diag *diag)
{
	static const char *const elements[] = {"Tool-Data", NULL};
	struct reading r = {.tools = tools};
	bool good;

	if (!xml_open_foreign(&r.xml, path, elements, diag))
		return false;
	good = read_xml(&r);
	arena_release(&r.arena);
	xml_close(&r.xml);
	return good;
}

/* --------------------------------------------------------------------- table */

static bool has_cell(const struct csv_table *table, const char *name)
{
	for (size_t i = 0; i < table->count; i++)
		if (!strcmp(table->cells[i], name))
			return true;
	return false;
}

bool din4000_table_is(const char *text)
{
	struct diag silent = {.handle = NULL};
	struct csv_table table;

	csv_table_begin(&table, text, NULL, &silent);
	return csv_table_next(&table) > 0 && has_cell(&table, "NSM") && has_cell(&table, "BLD");
}

bool din4000_table_read(struct tool_library *tools, const char *text, const char *path, struct diag *diag)
{
	struct csv_table table;
	struct record record = {0};
	char codes[CSV_COLUMNS_MAX][CSV_CELL_MAX + 1];
	size_t columns;
	int found;

	csv_table_begin(&table, text, path, diag);
	if (csv_table_next(&table) < 0)
		return false;
	columns = table.count;
	memcpy(codes, table.cells, sizeof(codes));
	while ((found = csv_table_next(&table)) > 0) {
		record = (struct record){.at = table.at};
		for (size_t i = 0; i < table.count && i < columns; i++)
			note_code(&record, codes[i], table.cells[i]);
		if (!add_tool(tools, &record, diag))
			return false;
	}
	return found == 0;
}
