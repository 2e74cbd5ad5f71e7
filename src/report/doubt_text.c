#include "report/doubt_text.h"

#include <assert.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "machine/kinematics_check.h"
#include "report/format/format_units.h"

#define AXIS_CHECKED "<axis name=\"{axis}\" checked=\"reason\">"
#define OR_AXIS_CHECKED ", or say why it is right: " AXIS_CHECKED
#define TURN_AXIS_ROUND "; reverse its direction" OR_AXIS_CHECKED
#define OR_CHECKED ", or give it checked=\"reason\""
#define HAS_NO_UNITS "(STL has none: units=\"inch\", \"cm\" or \"m\")"
#define GAUGE_AT_ORIGIN "a mesh has the gauge point at its origin and the tip toward -Z"

/* The text of each kind; {words} in braces are the names in `fields` and `number_fields`. */
static const char *const texts[] = {
	[DOUBT_LEFT_HANDED] = "X Y Z of the tool relative to the work are left-handed: a sign is wrong or two letters "
			      "are exchanged; check the directions, or give one of the axes checked=\"reason\"",
	[DOUBT_TURNED] = "X Y Z of the tool relative to the work are not those of the drawing: check the letters, or "
			 "give one of the axes checked=\"reason\"",
	[DOUBT_PARALLEL] = "axes {axis} and {other} both move the tool along one line relative to the work; only X and "
			   "U, Y and V, Z and W may do that: check their directions, or give one of them "
			   "checked=\"reason\"",
	[DOUBT_LETTER] = "axis {axis} {moves} {found letter}, not {letter}: check its name and its direction"
			 OR_AXIS_CHECKED,
	[DOUBT_SIGN] = "axis {axis}: a positive value moves the {goer} toward -{letter} relative to the work"
		       TURN_AXIS_ROUND,
	[DOUBT_ROTARY_SIGN] = "axis {axis}: a positive value turns the {turner} left-handed about {letter} relative to "
			      "the work (ISO 841: right-handed; an axis that turns the work has the opposite direction)"
			      TURN_AXIS_ROUND,
	[DOUBT_IDLE] = "axis {axis} moves neither the tool nor the work: the axis that should be nested in it is "
		       "beside it; check the nesting of the axes" OR_AXIS_CHECKED,
	[DOUBT_TURNS_ITSELF] = "axis {axis} only turns the tool about the tool's own line, because it is nested in "
			       "{other}: check which of them carries the other" OR_AXIS_CHECKED,
	[DOUBT_RATE_LOW] = "axis {axis} has a rate_max of only {axis value} {unit} a minute: check its units"
			   OR_AXIS_CHECKED,
	[DOUBT_RADIANS] = "axis {axis} has a travel of only {axis value} degrees: limits are degrees, not radians; "
			  "check them, or say why they are right: " AXIS_CHECKED,
	[DOUBT_TILTED] = "the direction of axis {axis} is {value} degrees off the straight: check its numbers (an "
			 "angle in radians needs more digits)" OR_AXIS_CHECKED,
	[DOUBT_SPINDLE_TILTED] = "the direction of the spindle is {value} degrees off the straight: check its numbers "
				 "(an angle in radians needs more digits), or give <spindle checked=\"reason\">",
	[DOUBT_ROTARY_MISSES] = "axis {axis} turns about a line that misses all that it carries by {value} mm: check "
				"its location and its direction, or give the axis checked=\"reason\"",
	[DOUBT_ROTARY_BESIDE] = "axis {axis} is not in the middle of any circle that it turns or that carries it: the "
				"nearest one, {limit 5} mm wide, is {value} mm beside it; check the location, or give "
				"the axis checked=\"reason\"",
	[DOUBT_SPINDLE_ACROSS] = "axis {axis} does not move the tool along the spindle (all axes at 0): check the "
				 "direction of both, or give <spindle checked=\"reason\">",
	[DOUBT_SPINDLE_TOWARD] = "axis {axis}: a positive value moves the tool where its tip points, into the work: "
				 "check the direction of the axis and of the spindle, or give "
				 "<spindle checked=\"reason\">",
	[DOUBT_SPINDLE_IN_HEAD] = "the spindle points into its own head: {body} reaches {value} mm ahead of the gauge "
				  "point: reverse the direction of <spindle> (from the gauge point to the tip)"
				  OR_CHECKED,
	[DOUBT_SPINDLE_AWAY] = "the spindle points away from the work: the workholding is at least {value} mm behind "
			       "the gauge point, wherever the axes stand: check direction and location of <spindle> "
			       "and <workholding>, or give one of them checked=\"reason\"",
	[DOUBT_SPINDLE_BESIDE] = "the spindle's line is not in the middle of any circle of the bodies that move with "
				 "it: the nearest one, {limit 5} mm wide, is {value} mm beside it; check the location "
				 "and the direction of <spindle>" OR_CHECKED,
	[DOUBT_SPINDLE_FAR] = "the spindle's gauge point is {value} mm away from the nearest body that moves with it "
			      "({body}): check its location and the units of the mesh, or give "
			      "<spindle checked=\"reason\">",
	[DOUBT_WORKHOLDING_BESIDE] = "the tool comes no nearer than {value} mm to the workholding sideways: check the "
				     "location of <workholding>, of <spindle> and the limits, or give one of them "
				     "checked=\"reason\"",
	[DOUBT_WORKHOLDING_FAR] = "the workholding is {value} mm away from the nearest body that moves with it "
				  "({body}): check its location and the units of the mesh, or give "
				  "<workholding checked=\"reason\">",
	[DOUBT_BODIES_SMALL] = "all bodies of the machine together are {value} mm large, but its longest travel is "
			       "{limit} mm: the meshes may have other units than the file (<body units=\"inch\">, "
			       "\"cm\" or \"m\")",
	[DOUBT_BODIES_LARGE] = "all bodies of the machine together are {value} mm large, but its longest travel is "
			       "{limit} mm: the meshes may have other units than the file (<body units=\"inch\">, "
			       "\"cm\" or \"m\")",
	[DOUBT_SPINDLE_BARE] = "no body moves with the spindle, so no head is checked: a <body> is missing or on "
			       "another axis, or give <spindle checked=\"reason\">",
	[DOUBT_WORKHOLDING_BARE] = "no body moves with the workholding, so no table is checked: a <body> is missing or "
				   "on another axis, or give <workholding checked=\"reason\">",
	[DOUBT_BASE_BARE] = "no body is fixed, so no bed is checked: a <body> of <base> is missing or on an axis, or "
			    "give <base checked=\"reason\">",
	[DOUBT_GAP] = "{body} and {against} are about {value} mm apart at home, and nothing else joins axis {axis} to "
		      "what carries it: a <body> is missing, drawn elsewhere or in other units" OR_AXIS_CHECKED,
	[DOUBT_EXCUSED_APART] = "{body} and {against} are excused as neighbours, but are about {value} mm apart: "
				"adjacent_within=\"\" of <pairs> is too large; lower it, and name pairs of a joint "
				"with <pair ... check=\"never\" reason=\"\"/>",
	[DOUBT_NEIGHBOURS_MEET] = "{body} and {against} are excused as neighbours, but with {axis} at {axis limit} "
				  "{unit} one stands {value} mm deep in the other: check the limits and what moves "
				  "with {axis}; draw what carries it as a body of its own, and check the rest with "
				  "<pair ... check=\"always\"/>" OR_AXIS_CHECKED,
	[DOUBT_TRAVEL_LONG] = "axis {axis} has a travel of {value 5} mm, but all bodies together reach over {limit 5} "
			      "mm along it: check its limits and the units of the meshes" OR_AXIS_CHECKED,
	[DOUBT_TRAVEL_ENDLESS] = "axis {axis} has unlimited travel, but other linear axes have limits: no position of "
				 "it is refused, and a limit_min or limit_max may be missing" OR_AXIS_CHECKED,
	[DOUBT_TWICE] = "{body} and {against} are one mesh in one place: one of them names the wrong file, or is drawn "
			"twice" OR_CHECKED,
	[DOUBT_ROTATION] = "{body} is turned by {value 5} degrees, which looks like an angle in radians: rotation is "
			   "in degrees; check it" OR_CHECKED,
	[DOUBT_WORKHOLDING_ROTATION] = "the workholding is turned by {value 5} degrees, which looks like an angle in "
				       "radians: rotation is in degrees; check it, or give "
				       "<workholding checked=\"reason\">",
	[DOUBT_FLOATS] = "{body} touches nothing that could hold it: {value} mm to {against}; check its location and "
			 "units" OR_CHECKED,
	[DOUBT_SINKS] = "{body} stands {value} mm deep in {against}; check its location, rotation and units" OR_CHECKED,
	[DOUBT_PART_LARGE] = "{body} is {value 5} mm large, but the machine's longest travel is {limit 5} mm; check "
			     "its units" OR_CHECKED,
	[DOUBT_BODY_SMALL] = "{body} is only {value} mm large, but the machine's longest travel is {limit 5} mm; check "
			     "its units " HAS_NO_UNITS OR_CHECKED,
	[DOUBT_PART_BELOW_CUTTERS] = "{body} is only {value} mm large, less than the thinnest cutter ({limit} mm); "
				     "check its units " HAS_NO_UNITS OR_CHECKED,
	[DOUBT_OUT_OF_STOCK] = "{body} extends {value} mm out of {against}, from which it is cut; check location, size "
			       "and units of both" OR_CHECKED,
	[DOUBT_PART_BELOW_STOCK] = "{body} is small beside {against}, from which it is cut: {value} and {limit 5} mm "
				   "long, and less than an eighth in every direction; check the units of "
				   "both" OR_CHECKED,
	[DOUBT_PART_BESIDE] = "{body} is out of reach: the tip of every tool stays {value} mm away from it, wherever "
			      "the axes stand; check its location and the limits" OR_CHECKED,
	[DOUBT_TOOL_SHORT] = "tool {tool} cannot reach the part: its tip stays {value} mm above it; check the tool's "
			     "length and the limits" OR_CHECKED,
	[DOUBT_TOOL_LONG] = "tool {tool} is {value 5} mm long, more than the travel along the spindle ({limit 5} mm); "
			    "check its length and units" OR_CHECKED,
	[DOUBT_TOOL_TINY] = "tool {tool} is only {value} mm long, though the travel along the spindle is {limit 5} mm; "
			    "check its length and units" OR_CHECKED,
	[DOUBT_TOOL_BELOW] = "tool {tool} is too long: even at its highest position its tip is {value} mm below all "
			     "that is set up; check its length and units" OR_CHECKED,
	[DOUBT_TOOL_BARE] = "tool {tool} {others} no <holder>, which is what collides first; describe it" OR_CHECKED,
	[DOUBT_HOLDER_TURNED] = "tool {tool} has a holder that is only {value} mm thick at the gauge line, but {limit} "
				"mm farther down: sections stack from the gauge line to the tip; check their order"
				OR_CHECKED,
	[DOUBT_TOOL_ENDS] = "tool {tool} is {limit 5} mm long, but its bodies end {value} mm below the gauge line: "
			    GAUGE_AT_ORIGIN "; check its place, direction and units" OR_CHECKED,
	[DOUBT_TOOL_ASIDE] = "tool {tool} is drawn beside the spindle's line: the middle of {body} is {value} mm off "
			     "it; " GAUGE_AT_ORIGIN OR_CHECKED,
	[DOUBT_RADIUS_OFFSET] = "tool {tool} has a diameter of {limit} mm, but the radius of its D is {value} mm: "
				"check that it is not a diameter" OR_CHECKED,
	[DOUBT_TOOL_SHARP] = "tool {tool} has a point or rim so thin that contact of its outermost {value} mm is not "
			     "found where a cutter may enter {limit} mm deep; give a smaller rapid_allowance or gouge"
			     OR_CHECKED,
	[DOUBT_TOOL_NAME] = "tool {tool} has a diameter of {value} mm, but its name says {limit} mm: check that the "
			    "diameter is not a radius" OR_CHECKED,
	[DOUBT_LENGTH_OFFSET] = "tool {tool} is {limit 5} mm long, but its length offset is {value 5} mm: with G43 its "
				"tip is {difference} mm from where the program assumes it; check length_offset"
				OR_CHECKED,
	[DOUBT_OFFSET_OUTSIDE] = "work offset {offset} has {axis} {position} {unit}, outside the axis' travel "
				 "({limit_min} to {limit_max} {unit}); check its values, their signs and units"
				 OR_CHECKED,
	[DOUBT_OFFSET_FAR] = "work offset {offset} is {value} mm away from all that is set up (which is {limit} mm "
			     "large); check its values, their signs and units" OR_CHECKED,
};

typedef void field_fn(struct strbuf *out, const struct scene *scene, const struct doubt *doubt);

static const struct axis *axis_of(const struct scene *scene, const struct doubt *doubt)
{
	return &scene->machine->axes[doubt->axis];
}

/* A number in the unit of the doubt's axis. */
static void add_in_unit(struct strbuf *out, const struct scene *scene, const struct doubt *doubt, double value)
{
	strbuf_addf(out, "%.6g", format_units_value(axis_of(scene, doubt)->slot, value));
}

static void add_axis(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	strbuf_addf(out, "%s", axis_of(scene, doubt)->name);
}

static void add_other(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	strbuf_addf(out, "%s", scene->machine->axes[doubt->other].name);
}

static void add_letter(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	strbuf_addf(out, "%c", "XYZ"[axis_of(scene, doubt)->slot % 3]);
}

static void add_found_letter(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	(void)scene;
	strbuf_addf(out, "%c", "XYZ"[doubt->other]);
}

static void add_moves(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	strbuf_addf(out, "%s", axis_of(scene, doubt)->rotary ? "turns about" : "moves along");
}

static bool carries_tool(const struct scene *scene, const struct doubt *doubt)
{
	return kinematics_side(scene->machine, axis_of(scene, doubt)) > 0;
}

static void add_goer(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	strbuf_addf(out, "%s", carries_tool(scene, doubt) ? "tool" : "work so that the tool goes");
}

static void add_turner(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	strbuf_addf(out, "%s", carries_tool(scene, doubt) ? "tool" : "work so that the tool turns");
}

static void add_unit(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	strbuf_addf(out, "%s", format_units_unit(axis_of(scene, doubt)->slot));
}

static void add_axis_value(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	strbuf_addf(out, "%.4g", format_units_value(axis_of(scene, doubt)->slot, doubt->value));
}

static void add_axis_limit(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	add_in_unit(out, scene, doubt, doubt->limit);
}

static void add_position(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	add_in_unit(out, scene, doubt, doubt->value);
}

static void add_limit_min(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	add_in_unit(out, scene, doubt, axis_of(scene, doubt)->limit_min);
}

static void add_limit_max(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	add_in_unit(out, scene, doubt, axis_of(scene, doubt)->limit_max);
}

static void add_body(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	format_units_add_plain(out, scene->bodies[doubt->body].body->name);
}

static void add_against(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	format_units_add_plain(out, scene->bodies[doubt->against].body->name);
}

static void add_tool(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	strbuf_addf(out, "%d", scene->setup->tools[doubt->item].number);
}

static void add_others(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	(void)scene;
	if (doubt->value > 0)
		strbuf_addf(out, "and %.0f more have", doubt->value);
	else
		strbuf_addf(out, "has");
}

static void add_offset(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	strbuf_addf(out, "%s", scene->setup->offsets[doubt->item].name);
}

/* The numbers of a doubt without rounding: the required digits differ from text to text. */
static const struct number_field {
	const char *name;
	size_t offset;	/* of the number in struct doubt */
	int digits;
} number_fields[] = {
	{"value", offsetof(struct doubt, value), 4}, {"value 5", offsetof(struct doubt, value), 5},
	{"limit", offsetof(struct doubt, limit), 4}, {"limit 5", offsetof(struct doubt, limit), 5},
};

static bool has_name(const char *name, const char *text, size_t length)
{
	return strlen(name) == length && !memcmp(name, text, length);
}

/* Adds the number with this name. False: there is none. */
static bool add_number(struct strbuf *out, const struct doubt *doubt, const char *name, size_t length)
{
	for (size_t i = 0; i < sizeof(number_fields) / sizeof(*number_fields); i++) {
		const struct number_field *field = &number_fields[i];
		double number;

		if (!has_name(field->name, name, length))
			continue;
		memcpy(&number, (const char *)doubt + field->offset, sizeof(number));
		strbuf_addf(out, "%.*g", field->digits, number);
		return true;
	}
	return false;
}

static void add_difference(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	(void)scene;
	strbuf_addf(out, "%.4g", fabs(doubt->value - doubt->limit));
}

static const struct {
	const char *name;
	field_fn *add;
} fields[] = {
	{"axis", add_axis}, {"other", add_other}, {"letter", add_letter}, {"found letter", add_found_letter},
	{"moves", add_moves}, {"goer", add_goer}, {"turner", add_turner}, {"unit", add_unit},
	{"axis value", add_axis_value}, {"axis limit", add_axis_limit}, {"position", add_position},
	{"limit_min", add_limit_min},
	{"limit_max", add_limit_max}, {"body", add_body}, {"against", add_against}, {"tool", add_tool},
	{"others", add_others}, {"offset", add_offset}, {"difference", add_difference},
};

static field_fn *find_field(const char *name, size_t length)
{
	size_t i = 0;

	while (!has_name(fields[i].name, name, length)) {
		i++;
		assert(i < sizeof(fields) / sizeof(*fields));
	}
	return fields[i].add;
}

void doubt_text_add(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	const char *text = texts[doubt->kind];

	for (;;) {
		const size_t plain = strcspn(text, "{"), field = strcspn(text + plain, "}");

		strbuf_add(out, text, plain);
		if (text[plain] == '\0')
			return;
		if (!add_number(out, doubt, text + plain + 1, field - 1))
			find_field(text + plain + 1, field - 1)(out, scene, doubt);
		text += plain + field + 1;
	}
}
