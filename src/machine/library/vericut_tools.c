#include "machine/library/vericut_tools.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "base/math/math_functions.h"
#include "base/units.h"
#include "machine/tool_solid.h"
#include "machine/xml/foreign_xml.h"
#include "machine/xml/xml_element.h"

struct reading {
	struct tool_library *tools;
	struct xml_reader xml;
	struct diag *diag;
	bool number_all;
	long next_number;	/* the smallest number that no tool read so far has */
	size_t unnumbered, unknown_shape;	/* tools that were left out */
};

/* A tool that cannot be used is not a fault of the file. */
enum taken { TAKEN, LEFT_OUT, FAULTY };

/* ---------------------------------------------------------------- outlines */

/*
 * <Origin><Z>: the height of a piece, mm. A missing value is 0; a piece beside the axis is not an outline about the
 * axis.
 */
static enum taken read_origin(struct reading *r, const xmlNode *parent, double *height)
{
	const xmlNode *origin = foreign_child(parent, "Origin");
	const char *const names[] = {"X", "Y", "Z"};
	double value[3] = {0};

	for (int i = 0; origin && i < 3; i++) {
		const xmlNode *at = foreign_child(origin, names[i]);

		if (at && !foreign_number(&r->xml, at, NULL, &value[i]))
			return FAULTY;
	}
	*height += r->xml.unit * value[2];
	return fabs(value[0]) + fabs(value[1]) > 0 ? LEFT_OUT : TAKEN;
}

/* <X> is the radius and <Z> the height, mm above the piece's own origin. */
static bool read_point(struct reading *r, const xmlNode *node, double *radius, double *height)
{
	const xmlNode *x = foreign_child(node, "X"), *z = foreign_child(node, "Z");

	if (!x || !z) {
		xml_error(&r->xml, node, NULL, "<%s> needs <X> and <Z>", (const char *)node->name);
		return false;
	}
	if (!foreign_number(&r->xml, x, NULL, radius) || !foreign_number(&r->xml, z, NULL, height))
		return false;
	*radius *= r->xml.unit;
	*height *= r->xml.unit;
	return true;
}

/*
 * The points of an outline, with arcs between them: <Arc> has a center, and CW for clockwise; its ends are the points
 * before and after it.
 */
static enum taken read_outline(struct reading *r, const xmlNode *sor, double base, struct tool_profile *profile)
{
	const xmlNode *arc = NULL;
	bool first = true;
	double r0 = 0, z0 = 0, r1, z1, rc, zc;

	for (const xmlNode *at = foreign_child(sor, NULL); at; at = foreign_next(at, NULL)) {
		if (foreign_is(at, "Arc"))
			arc = at;
		if (!foreign_is(at, "Pt"))
			continue;
		if (!read_point(r, at, &r1, &z1))
			return FAULTY;
		if (arc && !first) {
			const xmlNode *sense = foreign_child(arc, "Direction");
			bool right = sense && ascii_same(foreign_text(&r->tools->setup.arena, sense), "CW");

			if (!read_point(r, arc, &rc, &zc))
				return FAULTY;
			tool_profile_add_arc(profile, base + z0, r0, base + z1, r1, base + zc, rc,
					     !right);
		} else if (!first) {
			tool_profile_add(profile, base + z0, r0, base + z1, r1);
		}
		arc = NULL;
		first = false;
		r0 = r1;
		z0 = z1;
	}
	return TAKEN;
}

static bool read_value(struct reading *r, const xmlNode *apt, const char *name, double *value)
{
	const xmlNode *at = foreign_child(apt, name);

	*value = 0;
	return !at || foreign_number(&r->xml, at, NULL, value);
}

/* The seven parameters of APT's CUTTER: D diameter, R corner, A angle of the point against the plane, H height. */
static enum taken read_apt(struct reading *r, const xmlNode *apt, struct tool_outline *tool)
{
	const char *type = foreign_attribute(apt, "Type");
	double d, corner, angle, height, flutes, shank, unit = r->xml.unit;

	if (!type) {
		xml_error(&r->xml, apt, NULL, "<Apt> has no Type");
		return FAULTY;
	}
	if (!read_value(r, apt, "D", &d) || !read_value(r, apt, "R", &corner) ||
	    !read_value(r, apt, "A", &angle) || !read_value(r, apt, "H", &height) ||
	    !read_value(r, apt, "FluteLength", &flutes) || !read_value(r, apt, "ShankDiameter", &shank))
		return FAULTY;
	tool->has_tip = true;
	if (ascii_same(type, "FLAT END")) {
		tool->tip = TIP_FLAT;
	} else if (ascii_same(type, "BALL END")) {
		tool->tip = TIP_BALL;
	} else if (ascii_same(type, "BULL NOSE")) {
		tool->tip = corner > 0 ? TIP_BULL : TIP_FLAT;
		tool->corner = unit * corner;
	} else if (ascii_same(type, "DRILL") && angle > 0 && angle < 89) {
		tool->tip = TIP_CONE;
		tool->angle = (180 - 2 * angle) * math_acos(-1) / 180;
	} else {
		return LEFT_OUT;
	}
	if (!(d > 0 && height > 0 && flutes >= 0 && shank >= 0))
		return LEFT_OUT;
	tool->diameter = unit * d;
	if (flutes > 0 && flutes < height && shank > 0) {
		tool_profile_add(&tool->cutter, 0, unit * d / 2, unit * flutes, unit * d / 2);
		tool_profile_add(&tool->shank, unit * flutes, unit * shank / 2, unit * height, unit * shank / 2);
		return TAKEN;
	}
	tool->flute_length = unit * flutes;
	tool_profile_add(&tool->cutter, 0, unit * d / 2, unit * height, unit * d / 2);
	return TAKEN;
}

static enum taken worse(enum taken a, enum taken b)
{
	return a > b ? a : b;
}

/* <Cutter> or <Holder>: outlines, and in a cutter one of the shapes of APT. */
static enum taken read_group(struct reading *r, const xmlNode *group, struct tool_outline *tool,
			     struct tool_profile *profile)
{
	double base = 0;
	enum taken taken = read_origin(r, group, &base);

	for (const xmlNode *at = foreign_child(group, NULL); at; at = foreign_next(at, NULL)) {
		double height = base;

		if (foreign_is(at, "SOR")) {
			taken = worse(taken, read_origin(r, at, &height));
			taken = worse(taken, read_outline(r, at, height, profile));
		} else if (foreign_is(at, "Apt") && profile == &tool->cutter && !tool->has_tip && !profile->count) {
			taken = worse(taken, read_apt(r, at, tool));
		} else if (!foreign_is(at, "Origin")) {
			taken = worse(taken, LEFT_OUT);
		}
	}
	return taken;
}

/* ------------------------------------------------------------------- tools */

/* The whole number in an ID; 0: it is not a number. */
static long number_of(const char *id)
{
	long number = 0;

	for (const char *at = id; *at; at++) {
		if (*at < '0' || *at > '9' || number > 99999999)
			return 0;
		number = 10 * number + (*at - '0');
	}
	return number;
}

static double largest_diameter(const struct tool_profile *profile)
{
	double radius = 0;

	for (size_t i = 0; i < profile->count; i++)
		radius = fmax(radius, fmax(profile->pieces[i].radius_low, profile->pieces[i].radius_high));
	return 2 * radius;
}

/* <GagePoint><Z>: the height of the gauge line above the tip. Without it the top of the tool is used. */
static enum taken read_length(struct reading *r, const xmlNode *node, struct tool_outline *tool)
{
	const xmlNode *gauge = foreign_child(node, "GagePoint"), *z = gauge ? foreign_child(gauge, "Z") : NULL;

	tool->length = fmax(tool_profile_top(&tool->cutter),
			    fmax(tool_profile_top(&tool->shank), tool_profile_top(&tool->holder)));
	if (!z)
		return TAKEN;
	if (!foreign_number(&r->xml, z, NULL, &tool->length))
		return FAULTY;
	tool->length *= r->xml.unit;
	return tool->length >= TOOL_SECTION_MIN && tool->length <= TOOL_SIZE_MAX ? TAKEN : LEFT_OUT;
}

static enum taken read_shape(struct reading *r, const xmlNode *node, struct tool_outline *tool)
{
	enum taken taken = TAKEN;

	for (const xmlNode *at = foreign_child(node, NULL); at; at = foreign_next(at, NULL)) {
		if (foreign_is(at, "Cutter"))
			taken = worse(taken, read_group(r, at, tool, &tool->cutter));
		else if (foreign_is(at, "Holder"))
			taken = worse(taken, read_group(r, at, tool, &tool->holder));
	}
	taken = worse(taken, read_length(r, node, tool));
	if (!(tool->diameter > 0))
		tool->diameter = largest_diameter(&tool->cutter);
	/* Headings of the library have no shape. */
	return tool->cutter.count ? taken : worse(taken, LEFT_OUT);
}

static bool read_unit(struct reading *r, const xmlNode *node)
{
	const char *unit = foreign_attribute(node, "Units");

	if (unit && ascii_same(unit, "Millimeter"))
		r->xml.unit = 1;
	else if (unit && ascii_same(unit, "Inch"))
		r->xml.unit = MM_PER_INCH;
	else
		xml_error(&r->xml, node, unit ? "Units" : NULL, "the Units of <Tool> must be Millimeter or Inch");
	return !r->xml.errors;
}

static struct srcloc place_of(const struct reading *r, const xmlNode *node)
{
	return (struct srcloc){.file = r->xml.path, .line = xml_line(&r->xml, node)};
}

/* False: the file is faulty. */
static bool read_tool(struct reading *r, const xmlNode *node)
{
	struct arena *arena = &r->tools->setup.arena;
	const char *id = foreign_attribute(node, "ID");
	const xmlNode *description = foreign_child(node, "Description");
	struct tool_outline tool = {.number = id ? number_of(id) : 0};
	enum taken taken;

	if (!read_unit(r, node))
		return false;
	tool.name = description ? foreign_text(arena, description) : tool.number ? "" : id;
	taken = read_shape(r, node, &tool);
	if (taken == LEFT_OUT)
		r->unknown_shape += tool.cutter.count > 0 || foreign_child(node, "Cutter");
	if (taken == TAKEN && !tool.number && !r->number_all)
		r->unnumbered++;
	if (taken == TAKEN && !tool.number && r->number_all)
		tool.number = r->next_number++;
	if (taken == TAKEN && tool.number && tool_library_wants(r->tools, tool.number) &&
	    !tool_library_add(r->tools, &tool, place_of(r, node), r->diag))
		taken = FAULTY;
	tool_outline_release(&tool);
	return taken != FAULTY;
}

/* Numbers that the library itself uses are not assigned. */
static void find_free_number(struct reading *r, const xmlNode *list)
{
	r->next_number = 1;
	for (const xmlNode *at = foreign_child(list, "Tool"); at; at = foreign_next(at, "Tool")) {
		const char *id = foreign_attribute(at, "ID");
		long number = id ? number_of(id) : 0;

		if (number >= r->next_number)
			r->next_number = number + 1;
	}
}

static bool read_library(struct reading *r)
{
	const xmlNode *list = foreign_child(xml_root(&r->xml), "Tools");

	if (!list) {
		xml_error(&r->xml, xml_root(&r->xml), NULL, "the library has no <Tools>");
		return false;
	}
	find_free_number(r, list);
	for (const xmlNode *at = foreign_child(list, "Tool"); at; at = foreign_next(at, "Tool"))
		if (!read_tool(r, at))
			return false;
	return true;
}

static void tell_left_out(const struct reading *r)
{
	const struct srcloc at = {.file = r->xml.path};

	if (r->unnumbered)
		diag_warning(r->diag, at,
			     "tools left out because their ID is not a number: %zu; --number-tools numbers them in the "
			     "order of the library",
			     r->unnumbered);
	if (r->unknown_shape)
		diag_warning(r->diag, at,
			     "tools left out because a setup cannot have their shape (such as inserts or models): %zu",
			     r->unknown_shape);
}

bool vericut_tools_read(struct tool_library *tools, const char *path, bool number_all, struct diag *diag)
{
	static const char *const elements[] = {"CGTechToolLibrary", NULL};
	struct reading r = {.tools = tools, .diag = diag, .number_all = number_all};
	bool good;

	if (!xml_open(&r.xml, path, elements, diag))
		return false;
	good = read_library(&r) && !r.xml.errors;
	if (good && !tools->counts_left_out)
		tell_left_out(&r);
	tools->left_out += r.unnumbered + r.unknown_shape;
	xml_close(&r.xml);
	return good;
}
