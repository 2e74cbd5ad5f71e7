#include "machine/library/fusion_tools.h"

#include <math.h>
#include <string.h>

#include "base/math/math_functions.h"
#include "base/units.h"
#include "machine/library/json_file.h"
#include "machine/tool_solid.h"

/* mm: sizes in a library are rounded, so smaller differences do not matter. */
#define ROUNDED 0.005

/* The shape of a tool below its shank. */
enum shape {
	SHAPE_CYLINDER,
	SHAPE_BALL,
	SHAPE_BULL,
	SHAPE_POINT,
	SHAPE_CHAMFER,	/* TA is half the angle of its cone */
	SHAPE_SINK,	/* SIG is the angle of its cone */
	SHAPE_TAPER,	/* widens from DC at its tip */
	SHAPE_DOVETAIL,	/* narrows from DC at its tip */
	SHAPE_SPHERE
};

static const struct type_row {
	const char *name;
	enum shape shape;
	enum tool_kind kind;
	enum tool_hand hand;
} type_rows[] = {
	{"flat end mill", SHAPE_CYLINDER, TOOL_TURNS, HAND_UNKNOWN},
	{"ball end mill", SHAPE_BALL, TOOL_TURNS, HAND_UNKNOWN},
	{"bull nose end mill", SHAPE_BULL, TOOL_TURNS, HAND_UNKNOWN},
	{"face mill", SHAPE_BULL, TOOL_TURNS, HAND_UNKNOWN},
	{"slot mill", SHAPE_BULL, TOOL_TURNS, HAND_UNKNOWN},
	{"reamer", SHAPE_CYLINDER, TOOL_TURNS, HAND_UNKNOWN},
	{"counter bore", SHAPE_CYLINDER, TOOL_TURNS, HAND_UNKNOWN},
	{"boring bar", SHAPE_CYLINDER, TOOL_TURNS, HAND_UNKNOWN},
	{"thread mill", SHAPE_CYLINDER, TOOL_TURNS, HAND_UNKNOWN},
	{"tap right hand", SHAPE_CYLINDER, TOOL_TURNS, HAND_RIGHT},
	{"tap left hand", SHAPE_CYLINDER, TOOL_TURNS, HAND_LEFT},
	{"drill", SHAPE_POINT, TOOL_TURNS, HAND_UNKNOWN},
	{"spot drill", SHAPE_POINT, TOOL_TURNS, HAND_UNKNOWN},
	{"counter sink", SHAPE_SINK, TOOL_TURNS, HAND_UNKNOWN},
	{"chamfer mill", SHAPE_CHAMFER, TOOL_TURNS, HAND_UNKNOWN},
	{"tapered mill", SHAPE_TAPER, TOOL_TURNS, HAND_UNKNOWN},
	{"dovetail mill", SHAPE_DOVETAIL, TOOL_TURNS, HAND_UNKNOWN},
	{"lollipop mill", SHAPE_SPHERE, TOOL_TURNS, HAND_UNKNOWN},
	{"probe", SHAPE_SPHERE, TOOL_PROBES, HAND_UNKNOWN},
};

struct reading {
	struct tool_library *tools;
	struct diag *diag;
	const char *path;
	size_t index;	/* of the tool in the list, from 1 */
	size_t bare, ungauged;	/* tools without a holder; tools whose holder has no gauge line */
};

static bool fault(const struct reading *r, const char *what)
{
	diag_error(r->diag, (struct srcloc){.file = r->path}, "tool %zu of the list: %s", r->index, what);
	return false;
}

static void leave_out(const struct reading *r, const char *name, const char *why)
{
	if (!r->tools->counts_left_out)
		diag_warning(r->diag, (struct srcloc){.file = r->path}, "tool %zu of the list (%.60s) is left out: %s",
			     r->index, name, why);
	r->tools->left_out++;
}

/* mm per unit; 0: the unit is unknown. */
static double unit_of(const json_t *object, double fallback)
{
	const char *unit = json_string_value(json_object_get(object, "unit"));

	if (!unit)
		return fallback;
	if (!strcmp(unit, "millimeters"))
		return 1;
	return !strcmp(unit, "inches") ? MM_PER_INCH : 0;
}

/* A number times scale; if it is missing or null, the fallback. False: the value is not a finite number. */
static bool read_number(const json_t *object, const char *name, double scale, double fallback, double *value)
{
	double number = NAN;

	if (!json_file_number(object, name, &number))
		return false;
	*value = isnan(number) ? fallback : scale * number;
	return true;
}

struct geometry {
	double diameter, greatest, corner, point_angle, taper_angle, tip_diameter;	/* mm; degrees */
	double flutes, shoulder, shoulder_diameter, shank_diameter, below_holder, gauge;	/* gauge 0: not given */
};

static bool read_geometry(const json_t *geometry, double unit, struct geometry *g)
{
	return read_number(geometry, "DC", unit, 0, &g->diameter) && read_number(geometry, "RE", unit, 0, &g->corner) &&
	       read_number(geometry, "DCX", unit, g->diameter, &g->greatest) &&
	       read_number(geometry, "SIG", 1, 0, &g->point_angle) &&
	       read_number(geometry, "TA", 1, 0, &g->taper_angle) &&
	       read_number(geometry, "tip-diameter", unit, 0, &g->tip_diameter) &&
	       read_number(geometry, "LCF", unit, 0, &g->flutes) &&
	       read_number(geometry, "shoulder-length", unit, g->flutes, &g->shoulder) &&
	       read_number(geometry, "shoulder-diameter", unit, g->diameter, &g->shoulder_diameter) &&
	       read_number(geometry, "SFDM", unit, g->diameter, &g->shank_diameter) &&
	       read_number(geometry, "LB", unit, 0, &g->below_holder) &&
	       read_number(geometry, "assemblyGaugeLength", unit, 0, &g->gauge);
}

/* Adds the frustums of "segments" from the height upward, and raises the height. */
static bool add_segments(const json_t *part, double unit, struct tool_profile *profile, double *height)
{
	const json_t *list = json_object_get(part, "segments"), *segment;
	size_t i;

	if (!list || json_is_null(list))
		return true;
	if (!json_is_array(list))
		return false;
	json_array_foreach (list, i, segment) {
		double length, lower, upper;

		if (!read_number(segment, "height", unit, -1, &length) ||
		    !read_number(segment, "lower-diameter", unit, -1, &lower) ||
		    !read_number(segment, "upper-diameter", unit, -1, &upper) || length < 0 || lower < 0 || upper < 0)
			return false;
		tool_profile_add(profile, *height, lower / 2, *height + length, upper / 2);
		*height += length;
	}
	return true;
}

/* ------------------------------------------------------------------- shapes */

/* The height of a cone with the given half angle between two diameters. */
static double cone_height(double from, double to, double half_degrees)
{
	return (to - from) / 2 / math_tan(half_degrees * math_acos(-1) / 180);
}

/* Why no cone with this half angle (degrees) fits between the diameters of tip and cutter; NULL: it was added. */
static const char *add_cone(struct tool_outline *tool, const struct geometry *g, double half, const char *why)
{
	const double r = g->diameter / 2;
	double cone;

	if (!(half >= 1 && half <= 89) || g->tip_diameter < 0 || g->tip_diameter > g->diameter)
		return why;
	cone = cone_height(g->tip_diameter, g->diameter, half);
	/* Some engraving tools end within the cone: above the flutes they have a shank. */
	if (g->flutes > 0 && g->flutes < cone) {
		tool_profile_add(&tool->cutter, 0, g->tip_diameter / 2, g->flutes,
				 g->tip_diameter / 2 + (r - g->tip_diameter / 2) * g->flutes / cone);
		return NULL;
	}
	tool_profile_add(&tool->cutter, 0, g->tip_diameter / 2, cone, r);
	tool_profile_add(&tool->cutter, cone, r, fmax(g->flutes, cone), r);
	return NULL;
}

/*
 * The cone has the diameter DC in the plane of the tip, as if it had no corner radius. The corner radius rounds the
 * cone tangentially; if both roundings meet on the axis, the tip is a ball.
 */
static const char *add_taper(struct tool_outline *tool, const struct geometry *g)
{
	const double angle = radians(g->taper_angle), r = g->diameter / 2, round = g->corner;
	double flat, low;

	if (!(g->taper_angle >= 1 && g->taper_angle <= 80) || !(g->flutes > 0) || round < 0)
		return "the angle TA is missing, or not between 1 and 80 degrees, or the flute length LCF is missing";
	flat = r - round * (1 - math_sin(angle)) / math_cos(angle);
	low = round * (1 - math_sin(angle));
	if (flat < -ROUNDED || low > g->flutes)
		return "the corner radius RE is larger than the tip";
	flat = fmax(flat, 0);
	if (round > 0)
		tool_profile_add_arc(&tool->cutter, 0, flat, low, flat + round * math_cos(angle), round, flat, true);
	tool_profile_add(&tool->cutter, low, flat + round * math_cos(angle), g->flutes,
			 r + g->flutes * math_tan(angle));
	return NULL;
}

/* A face mill whose sides go from DC to its greatest diameter over the height of its flutes. */
static bool is_tapered_face(const struct geometry *g, enum shape shape)
{
	const double top = g->diameter + 2 * g->flutes * math_tan(radians(g->taper_angle));

	return shape == SHAPE_BULL && g->taper_angle > 0 && g->taper_angle <= 80 && g->greatest > g->diameter &&
	       fabs(g->greatest - top) <= ROUNDED;
}

static const char *add_dovetail(struct tool_outline *tool, const struct geometry *g)
{
	const double r = g->diameter / 2, top = r - g->flutes * math_tan(radians(g->taper_angle));

	if (!(g->taper_angle >= 1 && g->taper_angle <= 80) || !(g->flutes > 0) || g->corner > 0 || !(top > 0))
		return "the angle TA is missing, or not between 1 and 80 degrees, or the corners are rounded";
	tool_profile_add(&tool->cutter, 0, r, g->flutes, top);
	return NULL;
}

/* Adds a ball up to its neck, which is as thick as the shoulder. */
static void add_sphere(struct tool_outline *tool, const struct geometry *g)
{
	const double r = g->diameter / 2, neck = fmin(g->shoulder_diameter / 2, r);

	tool_profile_add_arc(&tool->cutter, 0, 0, r, r, r, 0, true);
	tool_profile_add_arc(&tool->cutter, r, r, r + sqrt(r * r - neck * neck), neck, r, 0, true);
}

/* Why the shape cannot be used; NULL: it was added. */
static const char *add_cutter(struct tool_outline *tool, const struct geometry *g, enum shape shape)
{
	double r = g->diameter / 2;

	if (is_tapered_face(g, shape))
		return add_taper(tool, g);
	if (g->greatest > g->diameter + ROUNDED)
		return "the greatest diameter DCX is larger than DC";
	tool->has_tip = shape < SHAPE_CHAMFER;
	switch (shape) {
	case SHAPE_CYLINDER:
		tool->tip = TIP_FLAT;
		break;
	case SHAPE_BALL:
		tool->tip = TIP_BALL;
		break;
	case SHAPE_BULL:
		if (fabs(g->taper_angle) > 0)
			return "the sides are tapered";
		tool->tip = g->corner > 0 ? TIP_BULL : TIP_FLAT;
		tool->corner = g->corner;
		break;
	case SHAPE_POINT:
		if (!(g->point_angle >= 1 && g->point_angle <= 179))
			return "the point angle SIG is missing, or not between 1 and 179 degrees";
		tool->tip = TIP_CONE;
		tool->angle = g->point_angle * math_acos(-1) / 180;
		break;
	case SHAPE_CHAMFER:
		return add_cone(tool, g, g->taper_angle,
				"the angle TA is missing, or not between 1 and 89 degrees, or the tip is thicker than "
				"the tool");
	case SHAPE_SINK:
		return add_cone(tool, g, g->point_angle / 2,
				"the angle SIG is missing, or not between 2 and 178 degrees, or the tip is thicker "
				"than the tool");
	case SHAPE_TAPER:
		return add_taper(tool, g);
	case SHAPE_DOVETAIL:
		return add_dovetail(tool, g);
	case SHAPE_SPHERE:
		add_sphere(tool, g);
		return NULL;
	}
	tool_profile_add(&tool->cutter, 0, r, g->flutes, r);
	return NULL;
}

/*
 * The shoulder, and the segments of "shaft" above it. Libraries do not say whether these begin at the end of the flutes
 * or of the shoulder: the outline has both, so that it encloses the tool. Above the segments the shank goes on to the
 * holder.
 */
static bool add_shaft(struct tool_outline *tool, const json_t *shaft, const struct geometry *g, double unit)
{
	const double cutter = tool_profile_top(&tool->cutter), flutes = g->flutes > 0 ? g->flutes : cutter;
	const double shoulder = fmax(g->shoulder, flutes), neck = g->shoulder_diameter / 2;
	const json_t *segments = json_object_get(shaft, "segments");
	const json_t *last = json_array_get(segments, json_array_size(segments) - 1);
	double low = flutes, high = shoulder, end;

	tool_profile_add(&tool->shank, cutter, neck, fmax(shoulder, cutter), neck);
	if (!add_segments(shaft, unit, &tool->shank, &low) || !add_segments(shaft, unit, &tool->shank, &high) ||
	    !read_number(last, "upper-diameter", unit, 0, &end))
		return false;
	end = fmax(end, g->shank_diameter) / 2;
	if (high < g->below_holder)
		tool_profile_add(&tool->shank, high, end, g->below_holder, end);
	return true;
}

/* Above the flutes: the shoulder and the shank, or the segments of "shaft". */
static bool add_shank(struct tool_outline *tool, const json_t *shaft, const struct geometry *g, double unit)
{
	double top = tool_profile_top(&tool->cutter), shoulder = fmax(g->shoulder, top);

	if (json_array_size(json_object_get(shaft, "segments")))
		return add_shaft(tool, shaft, g, unit);
	if (shoulder < g->below_holder) {
		tool_profile_add(&tool->shank, top, g->shoulder_diameter / 2, shoulder, g->shoulder_diameter / 2);
		tool_profile_add(&tool->shank, shoulder, g->shank_diameter / 2, g->below_holder, g->shank_diameter / 2);
	} else if (top < g->below_holder) {
		tool_profile_add(&tool->shank, top, g->shoulder_diameter / 2, g->below_holder,
				 g->shoulder_diameter / 2);
	}
	return true;
}

/*
 * The holder is at LB above the tip; its own gaugeLength is the height of its gauge line above its lower end. *known_to
 * is the height up to which the library describes the tool.
 */
static bool add_holder(struct tool_outline *tool, const json_t *holder, const struct geometry *g, double unit,
		       double *known_to)
{
	double top = g->below_holder, gauge = 0;

	if (json_is_object(holder)) {
		double own = unit_of(holder, unit);

		if (!(own > 0) || !add_segments(holder, own, &tool->holder, &top) ||
		    !read_number(holder, "gaugeLength", own, 0, &gauge))
			return false;
	}
	tool->length = g->gauge > 0 ? g->gauge : gauge > 0 ? g->below_holder + gauge : top;
	*known_to = top;
	return true;
}

/* -------------------------------------------------------------------- tools */

static const struct type_row *find_type(const char *name)
{
	for (size_t i = 0; i < sizeof(type_rows) / sizeof(*type_rows); i++)
		if (!strcmp(type_rows[i].name, name))
			return &type_rows[i];
	return NULL;
}

/* Why no tool has these sizes; NULL: they are possible. */
static const char *why_no_tool(const struct geometry *g, enum shape shape, const struct tool_outline *tool)
{
	/* The corner radius of a tapered mill may be larger than that of its tip. */
	const bool rounded = shape != SHAPE_TAPER && g->corner > g->diameter / 2;

	if (!(g->diameter > 0))
		return "the diameter DC is missing";
	if (!(g->below_holder > 0))
		return "the length below the holder LB is missing";
	if (g->flutes < 0 || g->corner < 0 || rounded || g->shank_diameter < 0 ||
	    g->shoulder_diameter < 0)
		return "the dimensions contradict each other";
	return tool->length >= TOOL_SECTION_MIN && tool->length <= TOOL_SIZE_MAX ?
		       NULL :
		       "the length up to the gauge line is not between 0.01 and 5000 mm";
}

/* What the library does not say of the holder; *known_to as in add_holder. */
static void tell_holder(struct reading *r, const json_t *holder, const struct geometry *g,
			const struct tool_outline *tool, double known_to)
{
	if (known_to < tool->length - TOOL_SECTION_MIN)
		diag_warning(
		    r->diag, (struct srcloc){.file = r->path},
		    "tool %ld: the holder between %g and %g mm above the tip is not known; it is assumed to be as "
		    "thick as the cutter; add the holder",
		    tool->number, known_to, tool->length);
	else if (!tool->holder.count)
		r->bare++;
	else if (!(g->gauge > 0) && !json_is_number(json_object_get(holder, "gaugeLength")))
		r->ungauged++;
}

/* H of a number that is not the tool's is another register of the control. */
static void tell_offset(const struct reading *r, const json_t *item, long number, double length)
{
	const json_t *offset = json_object_get(json_object_get(item, "post-process"), "length-offset");

	if (r->tools->counts_left_out || json_integer_value(offset) < 1 || json_integer_value(offset) == number)
		return;
	diag_warning(r->diag, (struct srcloc){.file = r->path},
		     "tool %ld: programs from this library use the length offset H%ld: add <offset number=\"%ld\" "
		     "length=\"%.9g\"/> to the setup, or give the tool the offset %ld in the library",
		     number, (long)json_integer_value(offset), (long)json_integer_value(offset), length, number);
}

static bool add_tool(struct reading *r, const json_t *item, const struct type_row *type, const char *name, long number)
{
	struct tool_outline tool = {
		.number = number, .entry = r->index, .name = name, .kind = type->kind, .hand = type->hand};
	double unit = unit_of(item, 1);
	struct geometry g;
	double known_to = 0;
	const char *why;
	bool good;

	if (!(unit > 0))
		return fault(r, "the unit must be millimeters or inches");
	if (!read_geometry(json_object_get(item, "geometry"), unit, &g))
		return fault(r, "a value of the geometry is not a number");
	/* A ball has a neck, which older libraries give as the shank. */
	if (type->shape == SHAPE_SPHERE && !json_object_get(json_object_get(item, "geometry"), "shoulder-diameter"))
		g.shoulder_diameter = g.shank_diameter;
	why = add_cutter(&tool, &g, type->shape);
	good = add_shank(&tool, json_object_get(item, "shaft"), &g, unit) &&
	       add_holder(&tool, json_object_get(item, "holder"), &g, unit, &known_to);
	tool.diameter = g.diameter;
	why = why ? why : good ? why_no_tool(&g, type->shape, &tool) : NULL;
	if (!good)
		fault(r, "the segments of shaft or holder are invalid");
	else if (why)
		leave_out(r, name, why);
	else
		good = tool_library_add(r->tools, &tool, (struct srcloc){.file = r->path}, r->diag);
	if (good && !why) {
		tell_holder(r, json_object_get(item, "holder"), &g, &tool, known_to);
		tell_offset(r, item, number, tool.length);
	}
	tool_outline_release(&tool);
	return good;
}

static bool read_tool(struct reading *r, const json_t *item)
{
	const char *type = json_string_value(json_object_get(item, "type"));
	const char *name = json_string_value(json_object_get(item, "description"));
	const json_t *number = json_object_get(json_object_get(item, "post-process"), "number");
	const struct type_row *row = type ? find_type(type) : NULL;

	if (!type)
		return fault(r, "the type is missing");
	name = name ? name : "";
	if (!row)
		leave_out(r, name, "a setup does not have this type of tool");
	else if (!json_is_integer(number) || json_integer_value(number) < 1)
		leave_out(r, name, "the post-process properties have no tool number");
	else
		return !tool_library_wants(r->tools, (long)json_integer_value(number)) ||
		       add_tool(r, item, row, name, (long)json_integer_value(number));
	return true;
}

static bool read_list(struct reading *r, const json_t *root)
{
	const json_t *list = json_is_object(root) ? json_object_get(root, "data") : root, *item;
	size_t i;

	if (!json_is_array(list)) {
		diag_error(r->diag, (struct srcloc){.file = r->path},
			   "this JSON file is not a Fusion 360 tool library, which has a list of tools in \"data\"");
		return false;
	}
	json_array_foreach (list, i, item) {
		r->index = i + 1;
		if (!read_tool(r, item))
			return false;
	}
	return true;
}

/* The checker itself doubts tools without a holder. */
static void tell_holders(const struct reading *r)
{
	const struct srcloc at = {.file = r->path};

	if (r->bare && !r->tools->counts_left_out)
		diag_warning(r->diag, at,
			     "tools without a holder: %zu; the length of each ends where its holder would begin: add "
			     "the holders and correct the lengths",
			     r->bare);
	if (r->ungauged && !r->tools->counts_left_out)
		diag_warning(r->diag, at,
			     "tools whose holder has no gauge length: %zu; the top of the holder counts as the gauge "
			     "line: compare the lengths with those of the machine",
			     r->ungauged);
}

bool fusion_tools_read(struct tool_library *tools, const char *path, struct diag *diag)
{
	struct reading r = {.tools = tools, .diag = diag, .path = path};
	json_t *root = json_file_read(path, diag);
	bool good;

	if (!root)
		return false;
	good = read_list(&r, root);
	if (good)
		tell_holders(&r);
	json_decref(root);
	return good;
}
