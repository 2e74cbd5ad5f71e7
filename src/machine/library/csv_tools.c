#include "machine/library/csv_tools.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "base/decimal.h"
#include "base/math/math_functions.h"
#include "base/strbuf.h"
#include "base/units.h"
#include "geom/tolerance.h"
#include "machine/library/csv_table.h"
#include "machine/tool_build.h"

enum column {
	COLUMN_NUMBER, COLUMN_NAME, COLUMN_UNITS, COLUMN_TYPE, COLUMN_LENGTH, COLUMN_DIAMETER, COLUMN_CORNER,
	COLUMN_POINT, COLUMN_TIP_DIAMETER, COLUMN_FLUTES, COLUMN_SHANK, COLUMN_STICKOUT, COLUMN_HOLDER,
	COLUMN_LENGTH_OFFSET, COLUMN_RADIUS_OFFSET, COLUMNS
};

/* Letters and digits only, in lower case. */
static const char *const column_names[COLUMNS] = {
	[COLUMN_NUMBER] = "number", [COLUMN_NAME] = "name", [COLUMN_UNITS] = "units", [COLUMN_TYPE] = "type",
	[COLUMN_LENGTH] = "length", [COLUMN_DIAMETER] = "diameter", [COLUMN_CORNER] = "cornerradius",
	[COLUMN_POINT] = "pointangle", [COLUMN_TIP_DIAMETER] = "tipdiameter", [COLUMN_FLUTES] = "flutelength",
	[COLUMN_SHANK] = "shankdiameter", [COLUMN_STICKOUT] = "stickout", [COLUMN_HOLDER] = "holderdiameter",
	[COLUMN_LENGTH_OFFSET] = "lengthoffset", [COLUMN_RADIUS_OFFSET] = "radiusoffset",
};

struct reading {
	struct tool_library *tools;
	struct diag *diag;
	double unit;	/* of the current row */
	struct csv_table table;
	int place[COLUMNS];	/* of each column; -1: the table has none */
};

/* A row in mm and radians; NAN: not given. */
struct row {
	long number;
	double value[COLUMNS];
};

static bool fault(const struct reading *r, const char *what)
{
	diag_error(r->diag, r->table.at, "%s", what);
	return false;
}

/* -------------------------------------------------------------- columns */

static bool is_named(const char *cell, const char *name)
{
	for (; *cell; cell++) {
		if (!ascii_is_alphanumeric(*cell))
			continue;
		if (ascii_lower(*cell) != *name++)
			return false;
	}
	return !*name;
}

static int find_column(const char *cell)
{
	if (is_named(cell, "unit"))
		return COLUMN_UNITS;
	for (int i = 0; i < COLUMNS; i++)
		if (is_named(cell, column_names[i]))
			return i;
	return -1;
}

/* Is it the name of a measure with its unit, as in "Diameter (mm)"? Without that column the tool would be wrong. */
static bool is_nearly_known(const char *cell)
{
	static const char *const units[] = {"mm", "in", "inch", "deg"};

	for (int i = COLUMN_LENGTH; i < COLUMNS; i++) {
		for (size_t k = 0; k < sizeof(units) / sizeof(*units); k++) {
			char name[32];

			snprintf(name, sizeof(name), "%s%s", column_names[i], units[k]);
			if (is_named(cell, name))
				return true;
		}
	}
	return false;
}

static bool find_columns(struct reading *r)
{
	struct strbuf unused = {0};
	bool good = true;

	for (int i = 0; i < COLUMNS; i++)
		r->place[i] = -1;
	for (size_t i = 0; i < r->table.count; i++) {
		int column = find_column(r->table.cells[i]);

		if (column < 0 && is_nearly_known(r->table.cells[i]))
			good = fault(r,
				     "the name of a column contains a unit; write only the name, and the unit into a "
				     "column units");
		else if (column < 0)
			strbuf_addf(&unused, "%s%.40s", unused.length ? ", " : "", r->table.cells[i]);
		else if (r->place[column] >= 0)
			good = fault(r, "two columns have the same name");
		else
			r->place[column] = (int)i;
	}
	if (good && unused.length)
		diag_note(r->diag, r->table.at, "unused columns: %s", strbuf_text(&unused));
	strbuf_release(&unused);
	return good;
}

static bool has(const struct reading *r, enum column column)
{
	return r->place[column] >= 0;
}

/* The text of a cell; "" if the table has no such column or the row ends earlier. */
static const char *cell_of(const struct reading *r, enum column column)
{
	return has(r, column) && (size_t)r->place[column] < r->table.count ? r->table.cells[r->place[column]] : "";
}

bool csv_tools_is(const char *text)
{
	struct diag silent = {.handle = NULL};
	struct reading r = {.diag = &silent};

	csv_table_begin(&r.table, text, NULL, &silent);
	if (csv_table_next(&r.table) <= 0 || r.table.count < 2)
		return false;
	find_columns(&r);
	return has(&r, COLUMN_NUMBER) &&
	       (has(&r, COLUMN_LENGTH) || has(&r, COLUMN_DIAMETER) || has(&r, COLUMN_LENGTH_OFFSET) ||
		has(&r, COLUMN_RADIUS_OFFSET));
}

/* ----------------------------------------------------------------- rows */

/* A decimal comma is a point if commas are not the separator. */
static bool read_value(struct reading *r, enum column column, double *value)
{
	char text[CSV_CELL_MAX + 1];
	char *comma;

	*value = NAN;
	strcpy(text, cell_of(r, column));
	comma = strchr(text, ',');
	if (comma && !strchr(text, '.'))
		*comma = '.';
	if (!text[0] || (decimal_read(text, strlen(text), value) && isfinite(*value)))
		return true;
	diag_error(r->diag, r->table.at, "%s must be a number, not '%.40s'", column_names[column],
		   cell_of(r, column));
	return false;
}

static bool read_unit(struct reading *r, double fallback)
{
	const char *unit = cell_of(r, COLUMN_UNITS);

	r->unit = fallback;
	if (!*unit) {
		r->tools->unit_is_assumed = true;
		return true;
	}
	if (ascii_same(unit, "mm") || ascii_same(unit, "millimeters"))
		r->unit = 1;
	else if (ascii_same(unit, "inch") || ascii_same(unit, "in") || ascii_same(unit, "inches"))
		r->unit = MM_PER_INCH;
	else
		return fault(r, "units must be mm or inch");
	return true;
}

static bool read_row(struct reading *r, double unit, struct row *row)
{
	double number;

	if (!read_unit(r, unit) || !read_value(r, COLUMN_NUMBER, &number))
		return false;
	if (!(number >= 1 && number <= TOOL_NUMBER_MAX) || floor(number) < number)
		return fault(r, "number must be a whole number, 1 or more");
	row->number = (long)number;
	for (int i = COLUMN_LENGTH; i < COLUMNS; i++) {
		if (!read_value(r, (enum column)i, &row->value[i]))
			return false;
		row->value[i] *= i == COLUMN_POINT ? radians(1) : r->unit;
		if (i < COLUMN_LENGTH_OFFSET && row->value[i] < 0) {
			diag_error(r->diag, r->table.at, "%s must not be negative", column_names[i]);
			return false;
		}
	}
	return true;
}

/* ---------------------------------------------------------------- tools */

static double or_else(double value, double fallback)
{
	return isnan(value) ? fallback : value;
}

/* Does the row have a type that is this word or begins with it? */
static bool is_type(const char *type, const char *word)
{
	return ascii_same_start(type, word, strlen(word));
}

static bool set_tip(struct reading *r, const struct row *row, struct tool_outline *tool)
{
	const char *type = cell_of(r, COLUMN_TYPE);
	const double corner = or_else(row->value[COLUMN_CORNER], 0), point = or_else(row->value[COLUMN_POINT], 0);
	const bool any = !*type;

	if (is_type(type, "bull") && !(corner > 0))
		return fault(r, "a bull nose mill needs a corner_radius; a flat mill in its place would cut more");
	if (is_type(type, "flat") && corner > 0)
		return fault(r, "a flat mill has no corner_radius; with a corner_radius the type is bull");
	if (is_type(type, "ball") && corner > 0 && fabs(corner - tool->diameter / 2) > TOOL_SUM_TOLERANCE)
		return fault(r,
			     "the corner_radius of a ball mill must be half its diameter; otherwise the type is bull");
	tool->has_tip = true;
	tool->tip = TIP_FLAT;
	if (is_type(type, "ball") || is_type(type, "probe") || (any && corner > 0 && corner >= tool->diameter / 2)) {
		tool->tip = TIP_BALL;
	} else if (is_type(type, "bull") || (any && corner > 0)) {
		tool->tip = corner > 0 ? TIP_BULL : TIP_FLAT;
		tool->corner = corner;
	} else if (is_type(type, "drill") || (any && point > 0)) {
		tool->tip = TIP_CONE;
		tool->angle = point;
	} else if (!is_type(type, "chamfer") && !is_type(type, "flat") && !any) {
		diag_error(r->diag, r->table.at, "type '%.40s' must be flat, ball, bull, drill, chamfer or probe",
			   type);
		return false;
	}
	/* Only these have a point: with another type one of the two cells is wrong. */
	if (point > 0 && tool->tip != TIP_CONE && !is_type(type, "chamfer"))
		return fault(r,
			     "only a drill or a chamfer mill has a point_angle: correct the type, or leave the cell "
			     "empty");
	if (tool->tip == TIP_CONE && !(tool->angle > 0 && tool->angle < radians(180)))
		return fault(r, "a drill needs a point_angle between 0 and 180 degrees");
	if (tool->corner > tool->diameter / 2)
		return fault(r, "the corner_radius is larger than half the diameter");
	return true;
}

/* A chamfer mill: a frustum from its tip diameter upward, with the full angle of its point. */
static bool add_chamfer(struct reading *r, const struct row *row, struct tool_outline *tool, double top)
{
	const double point = or_else(row->value[COLUMN_POINT], 0), tip = or_else(row->value[COLUMN_TIP_DIAMETER], 0);
	double rise;

	if (!(point > 0 && point < radians(180)) || tip >= tool->diameter)
		return fault(r,
			     "a chamfer mill needs a point_angle between 0 and 180 degrees and a tip_diameter below "
			     "its diameter");
	rise = (tool->diameter - tip) / 2 / math_tan(point / 2);
	if (rise > top)
		return fault(r, "the point of the chamfer mill is higher than its flutes");
	tool_profile_add(&tool->cutter, 0, tip / 2, rise, tool->diameter / 2);
	tool_profile_add(&tool->cutter, rise, tool->diameter / 2, top, tool->diameter / 2);
	tool->has_tip = false;
	return true;
}

static bool add_pieces(struct reading *r, const struct row *row, struct tool_outline *tool)
{
	const double stickout = fmin(or_else(row->value[COLUMN_STICKOUT], tool->length), tool->length);
	const double holder = or_else(row->value[COLUMN_HOLDER], 0);
	const double flutes = fmin(or_else(row->value[COLUMN_FLUTES], stickout), stickout);
	const double shank = or_else(row->value[COLUMN_SHANK], tool->diameter);

	if (row->value[COLUMN_STICKOUT] > tool->length + TOOL_SUM_TOLERANCE)
		return fault(r,
			     "the stickout is larger than the length, so the holder would begin above the gauge line");
	/* A thin stem of a probe may be as thick as its ball: it cuts nothing. */
	if (isnan(row->value[COLUMN_FLUTES]) &&
	    row->value[COLUMN_SHANK] > (tool->kind == TOOL_PROBES ? tool->diameter : 0))
		return fault(r,
			     "the tool has a shank_diameter, but no flute_length, so it is not known where the shank "
			     "begins");
	if (is_type(cell_of(r, COLUMN_TYPE), "chamfer")) {
		if (!add_chamfer(r, row, tool, flutes))
			return false;
	} else {
		tool_profile_add(&tool->cutter, 0, tool->diameter / 2, flutes, tool->diameter / 2);
	}
	if (isnan(row->value[COLUMN_FLUTES]) && tool->kind == TOOL_TURNS)
		diag_warning(r->diag, r->table.at,
			     "tool %ld has no flute_length, so everything below the holder counts as cutter, which may "
			     "touch the part while it cuts; give flute_length",
			     tool->number);
	if (flutes < stickout)
		tool_profile_add(&tool->shank, flutes, shank / 2, stickout, shank / 2);
	if (holder > 0 && stickout < tool->length)
		tool_profile_add(&tool->holder, stickout, holder / 2, tool->length, holder / 2);
	else
		diag_warning(r->diag, r->table.at,
			     "tool %ld: the holder is not known; it is assumed to be as thick as the %s up to the "
			     "gauge line; give stickout and holder_diameter",
			     tool->number, flutes < stickout ? "shank" : "cutter");
	return true;
}

static bool add_tool(struct reading *r, const struct row *row)
{
	struct tool_outline tool = {
		.number = row->number,
		.name = cell_of(r, COLUMN_NAME),
		.kind = is_type(cell_of(r, COLUMN_TYPE), "probe") ? TOOL_PROBES : TOOL_TURNS,
		.length = or_else(row->value[COLUMN_LENGTH], 0),
		.diameter = or_else(row->value[COLUMN_DIAMETER], 0),
	};
	bool good;

	if (!(tool.diameter > 0) || !(tool.length > 0))
		return fault(r, "the tool needs a length and a diameter greater than 0");
	good = set_tip(r, row, &tool) && add_pieces(r, row, &tool) &&
	       tool_library_add(r->tools, &tool, r->table.at, r->diag);
	tool_outline_release(&tool);
	return good;
}

static bool add_row(struct reading *r, const struct row *row)
{
	const double length = row->value[COLUMN_LENGTH_OFFSET], radius = row->value[COLUMN_RADIUS_OFFSET];
	const struct length_offset_description offset = {.number = row->number,
							  .length = {!isnan(length), or_else(length, 0)},
							  .radius = {!isnan(radius), or_else(radius, 0)}};

	if (!tool_library_wants(r->tools, row->number))
		return true;
	if ((has(r, COLUMN_LENGTH) || has(r, COLUMN_DIAMETER)) && !add_tool(r, row))
		return false;
	return !(offset.length.given || offset.radius.given) ||
	       tool_library_add_offset(r->tools, &offset, r->table.at, r->diag);
}

bool csv_tools_read(struct tool_library *tools, const char *text, const char *path, double unit, struct diag *diag)
{
	struct reading r = {.tools = tools, .diag = diag};
	int found;

	csv_table_begin(&r.table, text, path, diag);
	if (csv_table_next(&r.table) < 0 || !find_columns(&r))
		return false;
	while ((found = csv_table_next(&r.table)) > 0) {
		struct row row;

		if (!read_row(&r, unit, &row) || !add_row(&r, &row))
			return false;
	}
	return found == 0;
}
