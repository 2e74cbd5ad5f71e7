#include "machine/library/catalog_tool.h"

#include <math.h>

#include "base/strbuf.h"
#include "base/units.h"
#include "machine/tool_solid.h"

/* mm: the rounding of catalogues. */
#define ROUNDED 0.011

struct catalog_tool catalog_tool_empty(struct srcloc at)
{
	return (struct catalog_tool){
		.at = at,
		.diameter = NAN,
		.overall_length = NAN,
		.corner_radius = NAN,
		.chamfer_width = NAN,
		.chamfer_angle = NAN,
		.point_angle = NAN,
		.cutting_length = NAN,
		.neck_diameter = NAN,
		.neck_end = NAN,
		.shank_diameter = NAN,
		.shank_length = NAN,
	};
}

bool catalog_tools_are_numbered(bool number_all, const char *path, struct diag *diag)
{
	if (!number_all)
		diag_error(diag, (struct srcloc){.file = path},
			   "this is a catalogue, whose tools have no numbers: 'fivecheck import --number-tools' "
			   "numbers them and writes a setup, to which you add the holders");
	return number_all;
}

void catalog_tool_leave_out(struct tool_library *tools, const struct catalog_tool *tool, const char *why,
			    struct diag *diag)
{
	struct strbuf name = {0}, reason = {0};

	tools->left_out++;
	if (tools->counts_left_out)
		return;
	/* A string of a catalogue may contain anything, even line breaks. */
	strbuf_add_visible(&name, tool->name ? tool->name : "");
	strbuf_add_visible(&reason, why);
	diag_warning(diag, tool->at, "the tool '%.60s' is left out: %s", strbuf_text(&name), strbuf_text(&reason));
	strbuf_release(&name);
	strbuf_release(&reason);
}

/* Catalogues write 0 for a missing value. */
static double given(double value)
{
	return value > 0 ? value : 0;
}

/* Why these cannot be the sizes of a tool; NULL: they can. */
static const char *why_no_tool(const struct catalog_tool *t)
{
	const double radius = t->diameter / 2;

	if (!(t->diameter > 0 && t->diameter <= TOOL_SIZE_MAX))
		return "the cutting diameter is missing";
	if (!(t->overall_length > 0 && t->overall_length <= TOOL_SIZE_MAX))
		return "the overall length is missing";
	if (!(t->cutting_length >= TOOL_SECTION_MIN && t->cutting_length <= t->overall_length))
		return "the length of the cutting edges is missing, or longer than the tool";
	if (!(t->shank_diameter > 0 && t->shank_diameter <= TOOL_SIZE_MAX))
		return "the shank diameter is missing";
	if (given(t->corner_radius) > radius + ROUNDED || given(t->chamfer_width) >= radius)
		return "the corner is larger than half the diameter";
	if (given(t->corner_radius) > 0 && given(t->chamfer_width) > 0)
		return "the corner has both a radius and a chamfer";
	/* At other angles the side along which the width is measured matters, and catalogues do not give it. */
	if (given(t->chamfer_width) > 0 && !(fabs(t->chamfer_angle - 45) <= ROUNDED))
		return "the angle of the corner chamfer is not given as 45 degrees";
	if (given(t->chamfer_width) > t->cutting_length)
		return "the corner chamfer is higher than the cutting edges";
	if (t->shape == CATALOG_DRILL && !(t->point_angle >= 1 && t->point_angle <= 179))
		return "the point angle is missing, or not between 1 and 179 degrees";
	if (t->shape == CATALOG_BALL_MILL && given(t->corner_radius) > 0 && fabs(t->corner_radius - radius) > ROUNDED)
		return "the radius of the ball nose mill is not half its diameter";
	if (given(t->neck_diameter) > fmax(t->diameter, t->shank_diameter) + ROUNDED)
		return "the neck is thicker than cutter and shank";
	if (given(t->neck_diameter) > 0 && given(t->neck_end) > t->overall_length + ROUNDED)
		return "the neck is longer than the tool";
	if (t->shape == CATALOG_BALL_MILL && t->cutting_length < radius - ROUNDED)
		return "the cutting edges end within the ball";
	return NULL;
}

/* Adds the corner of a mill, and the cutter up to the end of the edges. */
static void add_cutter(struct tool_outline *tool, const struct catalog_tool *t)
{
	const double radius = t->diameter / 2, width = given(t->chamfer_width);

	if (t->shape == CATALOG_MILL && width > 0) {
		tool_profile_add(&tool->cutter, 0, radius - width, width, radius);
		tool_profile_add(&tool->cutter, width, radius, t->cutting_length, radius);
		return;
	}
	tool->has_tip = true;
	tool->tip = TIP_FLAT;
	if (t->shape == CATALOG_DRILL) {
		tool->tip = TIP_CONE;
		tool->angle = radians(t->point_angle);
	} else if (t->shape == CATALOG_BALL_MILL || (given(t->corner_radius) > 0 &&
						     fabs(t->corner_radius - radius) <= ROUNDED)) {
		tool->tip = TIP_BALL;
	} else if (given(t->corner_radius) > 0) {
		tool->tip = TIP_BULL;
		tool->corner = t->corner_radius;
	}
	tool_profile_add(&tool->cutter, 0, radius, t->cutting_length, radius);
}

/*
 * Between the edges and the shank the tool has a neck or a transition to the shank. The neck is used only as far as its
 * length is known, and not inside the shank. Between neck and shank the larger diameter of cutter and shank is used.
 */
static void add_shank(struct tool_outline *tool, const struct catalog_tool *t)
{
	const double known = given(t->shank_length), radius = t->shank_diameter / 2, neck = given(t->neck_diameter);
	const double neck_end = neck > 0 ? fmin(given(t->neck_end), t->overall_length - known) : 0;
	const double most = fmax(t->diameter, t->shank_diameter) / 2;
	double from = t->cutting_length, shank = fmax(t->overall_length - known, from);

	if (neck_end > from) {
		tool_profile_add(&tool->shank, from, neck / 2, neck_end, neck / 2);
		from = neck_end;
		shank = fmax(shank, from);
	}
	if (most > radius)
		tool_profile_add(&tool->shank, from, most, shank, most);
	else
		shank = from;
	tool_profile_add(&tool->shank, shank, radius, t->overall_length, radius);
}

static void warn(const struct tool_outline *tool, const struct catalog_tool *t, struct diag *diag)
{
	const bool sharp = t->shape == CATALOG_MILL && !(given(t->corner_radius) > 0) && !(given(t->chamfer_width) > 0);

	diag_warning(diag, t->at,
		     "tool %ld: the holder is not known, and the length of %g mm ends with the shank: add the holder "
		     "and correct the length%s",
		     tool->number, tool->length,
		     sharp ? "; the corner is assumed to be sharp, because the catalogue has neither a radius nor a "
			     "chamfer"
			   : "");
}

bool catalog_tool_add(struct tool_library *tools, const struct catalog_tool *t, struct diag *diag)
{
	const char *why = why_no_tool(t);
	struct tool_outline tool = {
		.number = (long)tools->setup.tool_count + 1,
		.name = t->name,
		.length = t->overall_length,
		.diameter = t->diameter,
	};
	bool good;

	if (why) {
		catalog_tool_leave_out(tools, t, why, diag);
		return true;
	}
	add_cutter(&tool, t);
	add_shank(&tool, t);
	good = tool_library_add(tools, &tool, t->at, diag);
	if (good)
		warn(&tool, t, diag);
	tool_outline_release(&tool);
	return good;
}
