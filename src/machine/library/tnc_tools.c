#include "machine/library/tnc_tools.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/math/math_functions.h"
#include "base/mem.h"
#include "base/units.h"
#include "geom/tolerance.h"
#include "machine/library/tnc_table.h"

/* "Tool table tool.t": T is 0.0 to 32767.9. */
enum { NUMBER_MAX = 32767, INDEXES = 10, NAME_MAX_BYTES = 16 };

/* The tool 5.1 gets the number 1000051 if it becomes a tool of a setup: no tool of the control has such a number. */
enum { INDEXED_FROM = 1000000 };

/* Degrees: points that a setup can have. */
#define POINT_MIN 1.0
#define POINT_MAX 179.0

static const char *const needed[] = {"T", "L", "R", NULL};

enum kind { KIND_MILL, KIND_POINTED, KIND_PROBE, KIND_OTHER };

/* A row in mm and degrees; a cell that is empty is 0. */
struct row {
	long number;
	int index;	/* of a tool with several rows; 0: the main one */
	struct strbuf name;
	double length, radius, corner;	/* L, R, R2 */
	double length_delta, radius_delta, corner_delta;	/* DL, DR, DR2 */
	double edges, point;	/* LCUTS, T-ANGLE */
	enum kind kind;
};

struct reading {
	struct tool_library *tools;
	struct diag *diag;
	double unit;
	bool shapes;
	struct tnc_table table;
	long *lines;	/* of each T that was read; 0: none */
	struct row main;	/* the last row without an index; its name is not kept */
	long enclosed;	/* the last tool whose other rows were found to be thicker */
	size_t bare, whole;	/* tools that were made, and those without LCUTS */
};

bool tnc_tools_is(const char *text)
{
	return tnc_table_is(text, needed, ".T");
}

static bool fault(const struct reading *r, const char *what)
{
	diag_error(r->diag, r->table.at, "%s", what);
	return false;
}

/* --------------------------------------------------------------------- rows */

/* "5", "5.1" or "5,1". */
static bool split_number(const char *text, struct row *row)
{
	const size_t digits = strspn(text, "0123456789");
	const bool indexed = text[digits] == '.' || text[digits] == ',';

	if (digits == 0 || digits > 5)
		return false;
	row->number = strtol(text, NULL, 10);
	row->index = 0;
	if (indexed && text[digits + 1] >= '0' && text[digits + 1] <= '9' && !text[digits + 2])
		row->index = text[digits + 1] - '0';
	else if (text[digits])
		return false;
	return row->number <= NUMBER_MAX;
}

/* False: the tool was in an earlier row, which was reported. */
static bool is_first(struct reading *r, const struct row *row, const char *text)
{
	long *line = &r->lines[row->number * INDEXES + row->index];

	if (*line) {
		diag_error(r->diag, r->table.at, "tool %s is given twice (also in line %ld)", text, *line);
		return false;
	}
	*line = r->table.at.line;
	return true;
}

/* Each T once. */
static bool read_tool(struct reading *r, struct row *row)
{
	struct strbuf text = {0};
	bool good = tnc_table_text(&r->table, "T", &text);

	if (good && !split_number(strbuf_text(&text), row)) {
		diag_error(r->diag, r->table.at,
			   "T must be a tool number from 0 to 32767, or one such as 5.1, not '%.20s'",
			   strbuf_text(&text));
		good = false;
	}
	good = good && is_first(r, row, strbuf_text(&text));
	strbuf_release(&text);
	return good;
}

/* An empty cell counts as 0. */
static bool read_value(const struct reading *r, const char *name, double unit, double *value)
{
	if (!tnc_table_number(&r->table, name, value))
		return false;
	*value = isnan(*value) ? 0 : unit * *value;
	return true;
}

/* The names and numbers of those types whose shape is not that of a mill. */
static bool read_kind(const struct reading *r, struct row *row)
{
	static const struct {
		const char *name;
		enum kind kind;
	} kinds[] = {{"DRILL", KIND_POINTED}, {"1", KIND_POINTED}, {"CENT", KIND_POINTED}, {"4", KIND_POINTED},
		     {"TCHP", KIND_PROBE},    {"21", KIND_PROBE},   {"TURN", KIND_OTHER}, {"29", KIND_OTHER},
		     {"GRIND", KIND_OTHER},   {"30", KIND_OTHER},   {"DRESS", KIND_OTHER}, {"31", KIND_OTHER}};
	struct strbuf text = {0};
	const bool good = tnc_table_text(&r->table, "TYP", &text);

	row->kind = KIND_MILL;
	for (size_t i = 0; i < sizeof(kinds) / sizeof(*kinds); i++)
		if (ascii_same(strbuf_text(&text), kinds[i].name))
			row->kind = kinds[i].kind;
	strbuf_release(&text);
	return good;
}

/* Is L given? Without it the row is for no tool, unless it says anything else of one. */
static bool check_length(const struct reading *r, const struct row *row, bool *empty)
{
	double length, radius;

	if (!tnc_table_number(&r->table, "L", &length) || !tnc_table_number(&r->table, "R", &radius))
		return false;
	*empty = isnan(length) && !(fabs(radius) > 0) && !row->name.length;
	if (!isnan(length) || *empty)
		return true;
	return fault(r, "the tool has no length L: give it, or remove the row");
}

static bool read_row(struct reading *r, struct row *row, bool *empty)
{
	const double unit = r->unit;

	return read_tool(r, row) && tnc_table_text(&r->table, "NAME", &row->name) && check_length(r, row, empty) &&
	       read_value(r, "L", unit, &row->length) && read_value(r, "R", unit, &row->radius) &&
	       read_value(r, "R2", unit, &row->corner) && read_value(r, "DL", unit, &row->length_delta) &&
	       read_value(r, "DR", unit, &row->radius_delta) && read_value(r, "DR2", unit, &row->corner_delta) &&
	       read_value(r, "LCUTS", unit, &row->edges) && read_value(r, "T-ANGLE", 1, &row->point) &&
	       read_kind(r, row);
}

/* ------------------------------------------------------------------- values */

/* "Tool compensation": the control adds the deltas of the table to L and R. */
static double compensated_length(const struct row *row)
{
	return row->length + row->length_delta;
}

static double compensated_radius(const struct row *row)
{
	return row->radius + row->radius_delta;
}

/* "5.1" */
static void make_key(char key[NAME_MAX_BYTES], const struct row *row)
{
	snprintf(key, NAME_MAX_BYTES, "%ld.%d", row->number, row->index);
}

static void add_values(struct reading *r, const struct row *row)
{
	char key[NAME_MAX_BYTES];
	const struct tool_values_description values = {
		.number = row->number,
		.key = row->index ? key : NULL,
		.part = row->index > 0,
		.name = row->index || !row->name.length ? NULL : strbuf_text(&row->name),
		.length = compensated_length(row),
		.radius = compensated_radius(row),
		.deltas = fabs(row->length_delta) > 0 || fabs(row->radius_delta) > 0,
	};

	make_key(key, row);
	tool_library_add_values(r->tools, &values);
}

/* ------------------------------------------------------------------- shapes */

/* Why the row does not describe a tool; NULL: it does. */
static const char *why_no_tool(const struct row *row)
{
	if (!(row->length > 0))
		return "its length L is not greater than 0, so it is not measured from the gauge line";
	if (!(row->radius > 0))
		return "its radius R is not greater than 0";
	if (row->corner < 0 || row->corner > row->radius + TOOL_SUM_TOLERANCE)
		return "its radius R2 is negative, or larger than R";
	return row->edges < 0 ? "its tooth length LCUTS is negative" : NULL;
}

/* The lower end. A ball, or a corner that is no larger than with DR2. */
static void set_tip(struct tool_outline *tool, const struct row *row)
{
	const bool ball = row->corner >= row->radius - TOOL_SUM_TOLERANCE &&
			  row->corner + row->corner_delta >= row->radius + row->radius_delta - TOOL_SUM_TOLERANCE;

	tool->has_tip = true;
	tool->tip = TIP_FLAT;
	if (row->kind == KIND_PROBE || ball) {
		tool->tip = TIP_BALL;
	} else if (row->corner + fmin(row->corner_delta, 0) > 0) {
		tool->tip = TIP_BULL;
		tool->corner = row->corner + fmin(row->corner_delta, 0);
	} else if (row->kind == KIND_POINTED && row->point >= POINT_MIN && row->point <= POINT_MAX) {
		tool->tip = TIP_CONE;
		tool->angle = radians(row->point);
	}
}

/* mm: the part of the cutter that its tip needs. */
static double tip_height(const struct tool_outline *tool)
{
	switch (tool->tip) {
	case TIP_BALL:
		return tool->diameter / 2;
	case TIP_BULL:
		return tool->corner;
	case TIP_CONE:
		return tool->diameter / 2 / math_tan(tool->angle / 2);
	case TIP_FLAT:
		break;
	}
	return 0;
}

/*
 * "Indexed tool": rows with an index describe other points of the tool, with smaller lengths. The shape is at least as
 * long and as thick as that of the main row. A shorter row does not describe the tip.
 */
static void enclose_main(const struct reading *r, struct row *row)
{
	const struct row *main = &r->main;

	if (!row->index || main->number != row->number)
		return;
	if (row->length + fmax(row->length_delta, 0) < main->length + fmax(main->length_delta, 0)) {
		row->length = main->length;
		row->length_delta = main->length_delta;
		row->corner = row->point = row->edges = 0;
	}
	if (row->radius + fmax(row->radius_delta, 0) < main->radius + fmax(main->radius_delta, 0)) {
		row->radius = main->radius;
		row->radius_delta = main->radius_delta;
		row->corner = row->point = 0;
	}
}

/* The shape of the main row is made without those of the other rows of the tool, which stand below it. */
static void check_thickness(struct reading *r, const struct row *row)
{
	const double radius = row->radius + fmax(row->radius_delta, 0);
	const double main = r->main.radius + fmax(r->main.radius_delta, 0);

	if (!row->index || !(radius > main + TOOL_SUM_TOLERANCE) || r->enclosed == row->number)
		return;
	r->enclosed = row->number;
	diag_warning(r->diag, r->table.at,
		     "tool %ld.%d has the radius %.9g mm, but tool %ld is made with %.9g mm: make it thicker from %.9g "
		     "mm below the gauge line upward",
		     row->number, row->index, radius, row->number, main, row->length);
}

static bool add_tool(struct reading *r, const struct row *row)
{
	struct row shape = *row;
	char key[NAME_MAX_BYTES];
	struct tool_outline tool = {.kind = row->kind == KIND_PROBE ? TOOL_PROBES : TOOL_TURNS};
	double radius, edges;
	bool good;

	check_thickness(r, row);
	enclose_main(r, &shape);
	make_key(key, row);
	tool.number = row->index ? INDEXED_FROM + row->number * INDEXES + row->index : row->number;
	tool.name = row->index ? key : strbuf_text(&row->name);
	tool.length = shape.length + fmax(shape.length_delta, 0);
	radius = shape.radius + fmax(shape.radius_delta, 0);
	tool.diameter = 2 * radius;
	tool_outline_compensate(&tool, compensated_length(row), compensated_radius(row));
	set_tip(&tool, &shape);
	edges = shape.edges > 0 ? fmin(fmax(shape.edges, tip_height(&tool)), tool.length) : tool.length;
	tool_profile_add(&tool.cutter, 0, radius, edges, radius);
	if (edges < tool.length)
		tool_profile_add(&tool.shank, edges, radius, tool.length, radius);
	good = tool_library_add(r->tools, &tool, r->table.at, r->diag);
	tool_outline_release(&tool);
	r->bare++;
	r->whole += !(shape.edges > 0) && row->kind != KIND_PROBE;
	return good;
}

static void leave_out(struct reading *r, const struct row *row, const char *why)
{
	diag_warning(r->diag, r->table.at, "tool %ld (%.60s) is left out: %s", row->number, strbuf_text(&row->name),
		     why);
	r->tools->left_out++;
}

/* Rows of tools that are not in the machine have a T only. */
static bool describe(struct reading *r, const struct row *row)
{
	const char *why = why_no_tool(row);

	if (!why)
		return add_tool(r, row);
	if (!row->name.length && !(fabs(row->length) > 0) && !(fabs(row->radius) > 0))
		return true;
	leave_out(r, row, why);
	add_values(r, row);
	return true;
}

/* --------------------------------------------------------------------- file */

/* T0 is the empty spindle. */
static bool check_zero(const struct reading *r, const struct row *row)
{
	return !(fabs(compensated_length(row)) > 0 || fabs(compensated_radius(row)) > 0) ||
	       fault(r, "T0 is no tool, so a setup cannot have its length or radius: set both to 0");
}

static bool take_row(struct reading *r, struct row *row)
{
	bool empty;

	if (!read_row(r, row, &empty))
		return false;
	if (!row->index)
		r->main = *row;
	if (empty)
		return true;
	if (row->index && row->number != r->main.number && r->shapes)
		return fault(r, "a row with an index must stand below the row of its tool without one");
	if (!row->number)
		return check_zero(r, row);
	if (!tool_library_wants(r->tools, row->number))
		return true;
	if (row->kind == KIND_OTHER)
		leave_out(r, row, "turning, grinding and dressing tools have other tables");
	else if (r->shapes)
		return describe(r, row);
	else
		add_values(r, row);
	return true;
}

static void warn_of_missing(const struct reading *r)
{
	const struct srcloc at = {.file = r->table.at.file};

	if (r->bare)
		diag_warning(r->diag, at,
			     "the table describes neither holders nor shanks: each of its %zu tools is as thick as its "
			     "cutter up to the gauge line; add the holders",
			     r->bare);
	if (r->whole)
		diag_warning(r->diag, at,
			     "tools without a tooth length (LCUTS): %zu; all of each counts as cutter, which may touch "
			     "the part while it cuts",
			     r->whole);
}

bool tnc_tools_read(struct tool_library *tools, const char *text, const char *path, double unit, bool shapes,
		    struct diag *diag)
{
	struct reading r = {.tools = tools, .diag = diag, .shapes = shapes};
	struct row row = {0};
	int found = -1;

	if (!tnc_table_begin(&r.table, text, path, needed, diag))
		return false;
	r.unit = r.table.unit > 0 ? r.table.unit : unit;
	tools->unit_is_assumed |= !(r.table.unit > 0);
	r.lines = mem_zalloc((NUMBER_MAX + 1) * INDEXES, sizeof(*r.lines));
	while ((found = tnc_table_next(&r.table)) > 0 && take_row(&r, &row))
		;
	if (found == 0)
		warn_of_missing(&r);
	strbuf_release(&row.name);
	free(r.lines);
	return found == 0;
}
