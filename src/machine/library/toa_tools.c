#include "machine/library/toa_tools.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "geom/tolerance.h"
#include "machine/library/toa_file.h"
#include "machine/tool_build.h"

/* $TC_DPn */
enum {
	DP_TYPE = 1, DP_LENGTH = 3, DP_LENGTH_2, DP_LENGTH_3, DP_RADIUS, DP_CORNER, DP_LENGTH_WEAR = 12,
	DP_LENGTH_2_WEAR, DP_LENGTH_3_WEAR, DP_RADIUS_WEAR, DP_CORNER_WEAR, DP_ADAPTER = 21, DP_ADAPTER_2, DP_ADAPTER_3
};

enum kind { KIND_OTHER, KIND_MILL, KIND_BALL, KIND_BULL, KIND_TAPERED, KIND_DRILL, KIND_PROBE, KIND_SIDE_PROBE };

struct reading {
	struct tool_library *tools;
	struct diag *diag;
	const char *path;
	double unit;
	bool shapes;
	struct toa_file file;
	size_t bare;	/* tools that were made */
};

/* How programs call a tool. */
struct identity {
	long number;
	const char *name;	/* NULL: by the number */
};

bool toa_tools_is(const char *text)
{
	return toa_file_is(text);
}

/* ------------------------------------------------------------------ values */

static double mm(const struct reading *r, const struct toa_edge *edge, int parameter)
{
	return r->unit * edge->value[parameter];
}

static double compensated_length(const struct reading *r, const struct toa_edge *edge)
{
	return mm(r, edge, DP_LENGTH) + mm(r, edge, DP_LENGTH_WEAR) + mm(r, edge, DP_ADAPTER);
}

static double compensated_radius(const struct reading *r, const struct toa_edge *edge)
{
	return mm(r, edge, DP_RADIUS) + mm(r, edge, DP_RADIUS_WEAR);
}

static struct srcloc place_of(const struct reading *r, const struct toa_edge *edge)
{
	return (struct srcloc){.file = r->path, .line = edge->line};
}

/* The whole number that is the name of a tool; 0: it is none. */
static long number_of(const char *name)
{
	const size_t digits = strspn(name, "0123456789");

	return digits && digits < 9 && !name[digits] ? strtol(name, NULL, 10) : 0;
}

/* With tool management, programs call $TC_TP2, and the number in $TC_DP is internal. */
static struct identity identity_of(const struct reading *r, long tool)
{
	const struct toa_tool *found = toa_file_tool(&r->file, tool);
	const char *name = found ? found->name : NULL;

	if (!name || !*name)
		return (struct identity){.number = tool};
	if (number_of(name))
		return (struct identity){.number = number_of(name)};
	return (struct identity){.number = tool, .name = name};
}

static enum kind kind_of(double type)
{
	const long number = type >= 1 && type <= 999 && !(floor(type) < type) ? (long)type : 0;

	if (number == 110)
		return KIND_BALL;
	if (number == 121)
		return KIND_BULL;
	/* Angle heads have another direction. */
	if (number == 130 || number == 131)
		return KIND_OTHER;
	if (number == 111 || (number >= 155 && number <= 157))
		return KIND_TAPERED;
	if (number >= 100 && number <= 199)
		return KIND_MILL;
	if (number >= 200 && number <= 299)
		return KIND_DRILL;
	/* L and star probes reach beside the axis. */
	if (number == 713 || number == 714)
		return KIND_SIDE_PROBE;
	return number >= 710 && number <= 719 ? KIND_PROBE : KIND_OTHER;
}

/* Lengths 2 and 3 are beside the axis of a mill or drill in the plane G17. */
static bool check_beside(const struct reading *r, const struct toa_edge *edge)
{
	const double second = mm(r, edge, DP_LENGTH_2) + mm(r, edge, DP_LENGTH_2_WEAR) + mm(r, edge, DP_ADAPTER_2);
	const double third = mm(r, edge, DP_LENGTH_3) + mm(r, edge, DP_LENGTH_3_WEAR) + mm(r, edge, DP_ADAPTER_3);

	if (!(fabs(second) > TOOL_SUM_TOLERANCE || fabs(third) > TOOL_SUM_TOLERANCE))
		return true;
	diag_error(r->diag, place_of(r, edge),
		   "D%ld of tool %ld has a length 2 or 3, but a setup can have only lengths along the tool: remove the "
		   "tool from the file, or leave it out with numbers=\"\" of <tools>",
		   edge->number, edge->tool);
	return false;
}

static void add_values(struct reading *r, const struct toa_edge *edge, const struct identity *identity)
{
	const struct tool_values_description values = {
		.number = identity->number,
		.key = identity->name,
		.edge = edge->number,
		.length = compensated_length(r, edge),
		.radius = compensated_radius(r, edge),
	};

	tool_library_add_values(r->tools, &values);
}

static const struct toa_edge *first_edge(const struct reading *r, long tool)
{
	for (size_t i = 0; i < r->file.edge_count; i++)
		if (r->file.edges[i].tool == tool && r->file.edges[i].number == 1)
			return &r->file.edges[i];
	return NULL;
}

/* Tools of one name replace each other: only the control knows which of them it loads. */
static bool check_twins(const struct reading *r, const struct toa_edge *edge, const struct identity *identity)
{
	for (size_t i = 0; i < r->file.tool_count; i++) {
		const struct toa_tool *twin = &r->file.tools[i];
		const struct toa_edge *other;

		if (!twin->name || twin->number == edge->tool || !ascii_same(twin->name, identity->name))
			continue;
		other = first_edge(r, twin->number);
		if (!other || other > edge || !tool_library_wants(r->tools, twin->number))
			continue;
		diag_error(r->diag, place_of(r, edge),
			   "the tools %ld and %ld have the name \"%s\" (also in line %ld): keep the one that is in the "
			   "machine, or choose with numbers=\"\" of <tools>",
			   other->tool, edge->tool, identity->name, other->line);
		return false;
	}
	return true;
}

/* ------------------------------------------------------------------ shapes */

/* Why the values do not describe a tool; NULL: they do. */
static const char *why_no_tool(const struct reading *r, const struct toa_edge *edge, enum kind kind)
{
	const double corner = mm(r, edge, DP_CORNER);

	if (!(mm(r, edge, DP_LENGTH) + mm(r, edge, DP_ADAPTER) > 0))
		return "its length $TC_DP3 is not greater than 0";
	if (!(mm(r, edge, DP_RADIUS) > 0))
		return "its radius $TC_DP6 is not greater than 0";
	if (kind == KIND_BULL && (corner < 0 || corner > mm(r, edge, DP_RADIUS)))
		return "its corner radius $TC_DP7 is negative, or larger than its radius";
	if (kind == KIND_SIDE_PROBE)
		return "the shape of an L or star probe is not described";
	return kind == KIND_TAPERED ? "a tapered or conical mill is not described completely" : NULL;
}

/* mm: how far the edge reaches below the gauge line, and its radius; with wear only if it makes the tool larger. */
static double reach_of(const struct reading *r, const struct toa_edge *edge)
{
	return mm(r, edge, DP_LENGTH) + mm(r, edge, DP_ADAPTER) + fmax(mm(r, edge, DP_LENGTH_WEAR), 0);
}

static double thickness_of(const struct reading *r, const struct toa_edge *edge)
{
	return mm(r, edge, DP_RADIUS) + fmax(mm(r, edge, DP_RADIUS_WEAR), 0);
}

/* The lower end, if `room` mm above it have the diameter of the tip; else it is flat, which encloses every tip. */
static void set_tip(const struct reading *r, const struct toa_edge *edge, enum kind kind, double room,
		    struct tool_outline *tool)
{
	const double corner = mm(r, edge, DP_CORNER) + fmin(mm(r, edge, DP_CORNER_WEAR), 0);

	tool->has_tip = true;
	tool->tip = TIP_FLAT;
	if (kind == KIND_BALL || kind == KIND_PROBE) {
		tool->tip = room >= thickness_of(r, edge) ? TIP_BALL : TIP_FLAT;
	} else if (kind == KIND_BULL && corner > 0 && room >= corner) {
		tool->tip = TIP_BULL;
		tool->corner = corner;
	}
}

/*
 * The tool is as thick as each edge, from there up to the gauge line, and as long as the longest of them: D1 need not
 * be at its lower end. Sets its length, outline, tip and diameter.
 */
static void enclose_edges(const struct reading *r, const struct toa_edge *first, enum kind kind,
			  struct tool_outline *tool)
{
	const double radius = thickness_of(r, first);
	double largest = radius, room;

	tool->length = reach_of(r, first);
	for (size_t i = 0; i < r->file.edge_count; i++)
		if (r->file.edges[i].tool == first->tool)
			tool->length = fmax(tool->length, reach_of(r, &r->file.edges[i]));
	room = tool->length > reach_of(r, first) ? 0 : tool->length;
	tool_profile_add(&tool->cutter, 0, radius, tool->length, radius);
	for (size_t i = 0; i < r->file.edge_count; i++) {
		const struct toa_edge *edge = &r->file.edges[i];
		const double wide = thickness_of(r, edge), low = tool->length - reach_of(r, edge);

		if (edge->tool != first->tool || !(wide > radius + TOOL_SUM_TOLERANCE) || !(low < tool->length))
			continue;
		tool_profile_add(&tool->cutter, low, wide, tool->length, wide);
		largest = fmax(largest, wide);
		room = fmin(room, low);
	}
	set_tip(r, first, kind, room, tool);
	tool->diameter = 2 * largest;
}

static bool add_tool(struct reading *r, const struct toa_edge *edge, const struct identity *identity, enum kind kind)
{
	struct tool_outline tool = {
		.number = identity->number,
		.name = identity->name,
		.kind = kind == KIND_PROBE ? TOOL_PROBES : TOOL_TURNS,
	};
	bool good;

	enclose_edges(r, edge, kind, &tool);
	tool_outline_compensate(&tool, compensated_length(r, edge), compensated_radius(r, edge));
	good = tool_library_add(r->tools, &tool, place_of(r, edge), r->diag);
	tool_outline_release(&tool);
	r->bare++;
	return good;
}

static void leave_out(struct reading *r, const struct toa_edge *edge, const struct identity *identity, const char *why)
{
	diag_warning(r->diag, place_of(r, edge), "tool %ld (%.60s) is left out: %s", edge->tool,
		     identity->name ? identity->name : "", why);
	r->tools->left_out++;
}

/* -------------------------------------------------------------------- file */

static bool take_tool(struct reading *r, const struct toa_edge *edge)
{
	const struct identity identity = identity_of(r, edge->tool);
	const enum kind kind = kind_of(edge->value[DP_TYPE]);
	const char *why = r->shapes ? why_no_tool(r, edge, kind) : NULL;

	if (!tool_library_wants(r->tools, identity.number))
		return true;
	if (kind == KIND_OTHER) {
		leave_out(r, edge, &identity, "its type $TC_DP1 is not that of a mill, a drill or a probe");
		return true;
	}
	if (!check_beside(r, edge))
		return false;
	if (r->shapes && !why)
		return add_tool(r, edge, &identity, kind);
	if (!r->shapes && identity.name && !check_twins(r, edge, &identity))
		return false;
	if (why)
		leave_out(r, edge, &identity, why);
	add_values(r, edge, &identity);
	return true;
}

static bool has_tool(const struct reading *r, long number)
{
	for (size_t i = 0; i < r->tools->setup.tool_count; i++)
		if (r->tools->setup.tools[i].number == number)
			return true;
	return false;
}

/* D2 and higher. */
static bool take_edge(struct reading *r, const struct toa_edge *edge)
{
	const struct toa_edge *first = first_edge(r, edge->tool);
	const struct identity identity = identity_of(r, edge->tool);
	const double radius = compensated_radius(r, edge);

	if (!tool_library_wants(r->tools, identity.number))
		return true;
	if (!first)
		leave_out(r, edge, &identity, "it has no edge D1");
	if (!first || kind_of(first->value[DP_TYPE]) == KIND_OTHER)
		return true;
	if (!check_beside(r, edge))
		return false;
	if (!r->shapes)
		add_values(r, edge, &identity);
	else if (has_tool(r, identity.number))
		tool_library_add_edge(r->tools, &(struct edge_description){.tool = identity.number,
									    .number = edge->number,
									    .length = compensated_length(r, edge),
									    .diameter = {radius > 0, 2 * radius},
									    .no_radius = !(radius > 0)});
	return true;
}

static bool take_all(struct reading *r)
{
	for (size_t i = 0; i < r->file.edge_count; i++)
		if (r->file.edges[i].number == 1 && !take_tool(r, &r->file.edges[i]))
			return false;
	for (size_t i = 0; i < r->file.edge_count; i++)
		if (r->file.edges[i].number > 1 && !take_edge(r, &r->file.edges[i]))
			return false;
	return true;
}

bool toa_tools_read(struct tool_library *tools, const char *text, const char *path, double unit, bool shapes,
		    struct diag *diag)
{
	struct reading r = {.tools = tools, .diag = diag, .path = path, .shapes = shapes};
	bool good = toa_file_read(&r.file, &tools->setup.arena, text, path, diag);

	r.unit = r.file.unit > 0 ? r.file.unit : unit;
	tools->unit_is_assumed |= !(r.file.unit > 0);
	good = good && take_all(&r);
	if (good && r.bare)
		diag_warning(diag, (struct srcloc){.file = path},
			     "the file describes neither holders nor shanks nor edges: each of its %zu tools is a "
			     "cutter up to the gauge line, which may touch the part while it cuts; add the holders",
			     r.bare);
	toa_file_release(&r.file);
	return good;
}
