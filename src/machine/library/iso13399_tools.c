#include "machine/library/iso13399_tools.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "base/decimal.h"
#include "base/strbuf.h"
#include "base/units.h"
#include "machine/library/catalog_tool.h"
#include "machine/library/step_entities.h"

/* The header names the schema. */
#define HEAD_MAX 8192

struct reading {
	struct step_entities entities;
	struct arena arena;
	struct strbuf why;	/* why the tool is left out; empty: it is not left out */
};

/* Sizes that are not in a catalog_tool. */
struct limits {
	double largest_diameter, body_diameter, usable_length, edge_angle, lead_angle, taper, flute_length;
};

bool iso13399_tools_is(const char *text)
{
	const char *start = text + strspn(text, " \t\r\n\xef\xbb\xbf"), *schema;

	if (strncmp(start, "ISO-10303-21", 12) != 0)
		return false;
	schema = strstr(start, "CUTTING_TOOL_SCHEMA");
	return schema && schema - start < HEAD_MAX;
}

/* Only the first reason is kept. */
static void leave_out(struct reading *r, const char *format, const char *what)
{
	if (!r->why.length)
		strbuf_addf(&r->why, "%s%s", format, what);
}

/* -------------------------------------------------------------------- values */

/* Lengths and angles that do not affect the shape of a mill or a drill. */
static const char *const harmless[] = {
	"FHA", "flute helix angle", "LF", "functional length", "LPR", "protruding length", "tool assembly length",
	"OHX", "overhang maximum", "OHN", "overhang minimum", "LSCMS", "clamping length machine side",
	"GAMF", "rake angle radial", "GAMP", "rake angle axial", "GAMO", "rake angle orthogonal",
	"RMPX", "ramping angle maximum", "KAPPA", "PHI", "RHO", "xyw plane distance", "xzw plane distance",
	"yzw plane distance", "LUX", "usable length maximum", "PL", "point length", "LN", "neck length",
	"LH", "head length", "LB", "body length", "residual grinding length",
	"PDX", "plunge depth maximum", "diameter hole tolerance lower",
	"diameter hole tolerance upper", "corner radius lower tolerance", "corner radius upper tolerance",
};

/* Properties without a unit that only tools with inserts have. */
static const char *const of_inserts[] = {
	"CICT", "cutting item count", "insert index count", "insert mounting style code",
};

static bool is_among(const char *name, const char *const *list, size_t count)
{
	for (size_t i = 0; i < count; i++)
		if (ascii_same(name, list[i]))
			return true;
	return false;
}

/* mm or degrees per unit of the value; 0: it has another unit or none. */
static double unit_of(struct reading *r, const struct step_entity *value, bool *angle)
{
	const struct step_entity *unit = step_entities_find(&r->entities, step_entity_reference(value, 2));
	const char *name = unit && step_entity_is(unit, "UNIT") ? step_entity_argument(unit, 0, &r->arena) : "";

	*angle = ascii_same(name, "deg");
	if (ascii_same(name, "mm") || *angle)
		return 1;
	return ascii_same(name, "in") || ascii_same(name, "inch") ? MM_PER_INCH : 0;
}

/* NUMERICAL_VALUE ('DC', $, #unit, '6.35') */
static void read_value(struct reading *r, const struct step_entity *entity, struct catalog_tool *tool, struct limits *l)
{
	const struct {
		const char *symbol, *name;
		double *size;
		bool angle;
	} rows[] = {
		{"DC", "cutting diameter", &tool->diameter, false},
		{"OAL", "overall length", &tool->overall_length, false},
		{"APMX", "depth of cut maximum", &tool->cutting_length, false},
		{"LCF", "length chip flute", &l->flute_length, false},
		{"RE", "corner radius", &tool->corner_radius, false},
		{"CHW", "corner chamfer width", &tool->chamfer_width, false},
		{"KCH", "corner chamfer angle", &tool->chamfer_angle, true},
		{"SIG", "point angle", &tool->point_angle, true},
		{"DN", "neck diameter", &tool->neck_diameter, false},
		{"LU", "usable length", &l->usable_length, false},
		{"DCONMS", "connection diameter machine side", &tool->shank_diameter, false},
		{"DMM", "shank diameter", &tool->shank_diameter, false},
		{"LS", "shank length", &tool->shank_length, false},
		{"DCX", "cutting diameter maximum", &l->largest_diameter, false},
		{"BD", "body diameter", &l->body_diameter, false},
		{"KAPR", "tool cutting edge angle", &l->edge_angle, true},
		{"PSIR", "tool lead angle", &l->lead_angle, true},
		{"BHTA", "body half taper angle", &l->taper, true},
	};
	const char *name = step_entity_argument(entity, 0, &r->arena);
	const char *text = step_entity_argument(entity, 3, &r->arena);
	bool angle;
	const double unit = unit_of(r, entity, &angle);
	double value;

	if (is_among(name, of_inserts, sizeof(of_inserts) / sizeof(*of_inserts)))
		leave_out(r, "the cutting edges are inserts", "");
	for (size_t i = 0; i < sizeof(rows) / sizeof(*rows); i++) {
		if (!ascii_same(name, rows[i].symbol) && !ascii_same(name, rows[i].name))
			continue;
		if (!(unit > 0) || angle != rows[i].angle || !decimal_read(text, strlen(text), &value) ||
		    !isfinite(value) || value < 0)
			leave_out(r, "a value is not a length in mm or inch, or not an angle in degrees: ", name);
		else if (!isnan(*rows[i].size) && fabs(*rows[i].size - unit * value) > 0)
			leave_out(r, "two values of the same property: ", name);
		else
			*rows[i].size = unit * value;
		return;
	}
	if (unit > 0 && !is_among(name, harmless, sizeof(harmless) / sizeof(*harmless)))
		leave_out(r, "the shape is not known because of the property: ", name);
}

/* --------------------------------------------------------------------- items */

/* ITEM (description, 'id', #name): the name of the product, else its id. */
static const char *name_of(struct reading *r, const struct step_entity *item)
{
	const struct step_entity *texts = step_entities_find(&r->entities, step_entity_reference(item, 2));
	const struct step_entity *text =
		texts && step_entity_is(texts, "MULTI_LANGUAGE_STRING") ?
			step_entities_find(&r->entities, step_entity_reference(texts, 1)) :
			NULL;
	const char *name = text && step_entity_is(text, "STRING_WITH_LANGUAGE") ?
				   step_entity_argument(text, 0, &r->arena) :
				   "";

	return *name ? name : step_entity_argument(item, 1, &r->arena);
}

/* The item to which a value belongs is not examined: a file with several products is left out. */
static void read_items(struct reading *r, struct catalog_tool *tool)
{
	size_t items = 0;
	bool is_tool = false;

	for (size_t i = 0; i < r->entities.count; i++) {
		const struct step_entity *entity = &r->entities.items[i];

		if (step_entity_is(entity, "ITEM")) {
			items++;
			tool->name = name_of(r, entity);
			tool->at.line = entity->line;
		} else if (step_entity_is(entity, "SPECIFIC_ITEM_CLASSIFICATION")) {
			const char *kind = step_entity_argument(entity, 1, &r->arena);

			is_tool |= !strcmp(kind, "tool item");
			if (!strcmp(kind, "adaptive item") || !strcmp(kind, "cutting item") ||
			    !strncmp(kind, "assembl", 7))
				leave_out(r, "not a complete tool, but of the kind: ", kind);
		}
	}
	if (items != 1)
		leave_out(r, "the file does not describe exactly one product", "");
	if (!is_tool)
		leave_out(r, "the file does not say that the product is a tool item", "");
}

/* Leaves out tools with sizes that a plain mill or drill does not have. */
static void leave_out_special(struct reading *r, const struct catalog_tool *tool, const struct limits *l)
{
	if (fabs(l->largest_diameter - tool->diameter) > 0.001)
		leave_out(r, "the greatest diameter DCX differs from the diameter DC", "");
	if (l->body_diameter > fmax(tool->diameter, tool->shank_diameter))
		leave_out(r, "the body is thicker than cutter and shank", "");
	if (tool->shape == CATALOG_MILL && fabs(l->edge_angle - 90) > 0.001)
		leave_out(r, "the cutting edges (KAPR) are not parallel to the axis", "");
	if (tool->shape == CATALOG_MILL && fabs(l->lead_angle) > 0.001)
		leave_out(r, "the cutting edges (PSIR) are not parallel to the axis", "");
	if (fabs(l->taper) > 0)
		leave_out(r, "the body is tapered", "");
}

bool iso13399_tools_read(struct tool_library *tools, const char *text, const char *path, struct diag *diag)
{
	struct limits limits = {NAN, NAN, NAN, NAN, NAN, NAN, NAN};
	struct catalog_tool tool = catalog_tool_empty((struct srcloc){.file = path});
	struct reading r = {0};
	bool good = step_entities_read(&r.entities, text, path, diag);

	if (good)
		read_items(&r, &tool);
	for (size_t i = 0; good && i < r.entities.count; i++)
		if (step_entity_is(&r.entities.items[i], "NUMERICAL_VALUE"))
			read_value(&r, &r.entities.items[i], &tool, &limits);
	tool.shape = isnan(tool.point_angle) ? CATALOG_MILL : CATALOG_DRILL;
	tool.neck_end = limits.usable_length;
	/* The flutes of a drill are its cutter. */
	if (tool.shape == CATALOG_DRILL || isnan(tool.cutting_length))
		tool.cutting_length = isnan(limits.flute_length) ? tool.cutting_length : limits.flute_length;
	leave_out_special(&r, &tool, &limits);
	if (good && r.why.length)
		catalog_tool_leave_out(tools, &tool, strbuf_text(&r.why), diag);
	else if (good)
		good = catalog_tool_add(tools, &tool, diag);
	strbuf_release(&r.why);
	arena_release(&r.arena);
	step_entities_release(&r.entities);
	return good;
}
