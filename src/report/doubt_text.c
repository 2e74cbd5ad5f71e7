#include "report/doubt_text.h"

#include <math.h>

#include "machine/kinematics_check.h"
#include "report/format/format_units.h"

static const char letters[] = "XYZ";

static void add_name(struct strbuf *out, const struct scene *scene, int body)
{
	format_units_add_plain(out, scene->bodies[body].body->name);
}

/* Where the drawn direction is, and how to silence the doubt about an axis. */
static void add_way_out(struct strbuf *out, const struct axis *axis)
{
	strbuf_addf(out, "; turn its direction round, or say why it is right: <axis name=\"%s\" checked=\"reason\">",
		    axis->name);
}

static void add_axis_doubt(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	const struct axis *axis = &scene->machine->axes[doubt->axis];
	const struct axis *other = &scene->machine->axes[doubt->other];
	int side = kinematics_side(scene->machine, axis);

	switch (doubt->kind) {
	case DOUBT_PARALLEL:
		strbuf_addf(out,
			    "axes %s and %s both move the tool along one line against the work; only X and U, Y and V, "
			    "Z and W may do that: check their directions, or give one of them checked=\"reason\"",
			    axis->name, other->name);
		break;
	case DOUBT_LETTER:
		strbuf_addf(out, "axis %s %s %c, not %c: check its name and its direction, or say why it is right: "
				 "<axis name=\"%s\" checked=\"reason\">",
			    axis->name, axis->rotary ? "turns about" : "moves along", letters[doubt->other],
			    letters[axis->slot % 3], axis->name);
		break;
	case DOUBT_SIGN:
		strbuf_addf(out, "axis %s: a positive value moves the %s toward -%c against the work", axis->name,
			    side > 0 ? "tool" : "work so that the tool goes", letters[axis->slot % 3]);
		add_way_out(out, axis);
		break;
	case DOUBT_ROTARY_SIGN:
		strbuf_addf(out,
			    "axis %s: a positive value turns the %s left-handed about %c against the work (ISO 841: "
			    "right-handed; an axis that turns the work has the opposite direction)",
			    axis->name, side > 0 ? "tool" : "work so that the tool turns", letters[axis->slot % 3]);
		add_way_out(out, axis);
		break;
	case DOUBT_IDLE:
		strbuf_addf(out,
			    "axis %s moves neither the tool nor the work: the axis that should be nested in it is "
			    "beside it; check the nesting of the axes, or say why it is right: <axis name=\"%s\" "
			    "checked=\"reason\">",
			    axis->name, axis->name);
		break;
	case DOUBT_TURNS_ITSELF:
		strbuf_addf(out,
			    "axis %s only turns the tool about the tool's own line, because it is nested in %s: check "
			    "which of them carries the other, or say why it is right: <axis name=\"%s\" "
			    "checked=\"reason\">",
			    axis->name, other->name, axis->name);
		break;
	case DOUBT_RATE_LOW:
		strbuf_addf(out,
			    "axis %s has a rate_max of only %.4g %s a minute: check its units, or say why it is right: "
			    "<axis name=\"%s\" checked=\"reason\">",
			    axis->name, format_units_value(axis->slot, doubt->value), format_units_unit(axis->slot),
			    axis->name);
		break;
	case DOUBT_RADIANS:
		strbuf_addf(out,
			    "axis %s has a travel of only %.4g degrees: limits are degrees, not radians; check them, "
			    "or say why they are right: <axis name=\"%s\" checked=\"reason\">",
			    axis->name, format_units_value(axis->slot, doubt->value), axis->name);
		break;
	case DOUBT_ROTARY_MISSES:
		strbuf_addf(
		    out,
		    "axis %s turns about a line that misses all that it carries by %.4g mm: check its location and "
		    "its direction, or give the axis checked=\"reason\"",
		    axis->name, doubt->value);
		break;
	case DOUBT_ROTARY_BESIDE:
		strbuf_addf(
		    out,
		    "no circle of what axis %s turns, or of what carries it, has its middle on the axis: the nearest "
		    "one, %.5g mm wide, is %.4g mm beside it; check the location, or give the axis checked=\"reason\"",
		    axis->name, doubt->limit, doubt->value);
		break;
	case DOUBT_SPINDLE_ACROSS:
		strbuf_addf(
		    out,
		    "axis %s does not move the tool along the spindle (all axes at 0): check the direction of both, or "
		    "give <spindle checked=\"reason\">",
		    axis->name);
		break;
	default:
		strbuf_addf(out,
			    "axis %s: a positive value moves the tool where its tip points, into the work: check the "
			    "direction of the axis and of the spindle, or give <spindle checked=\"reason\">",
			    axis->name);
		break;
	}
}

static void add_place_doubt(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	switch (doubt->kind) {
	case DOUBT_SPINDLE_IN_HEAD:
		strbuf_addf(out, "the spindle points into its own head: ");
		add_name(out, scene, doubt->body);
		strbuf_addf(
		    out,
		    " reaches %.4g mm ahead of the gauge point: turn the direction of <spindle> round (from the gauge "
		    "point to the tip), or give it checked=\"reason\"",
		    doubt->value);
		break;
	case DOUBT_SPINDLE_AWAY:
		strbuf_addf(
		    out,
		    "the spindle points away from the work: the workholding is at least %.4g mm behind the gauge "
		    "point, "
		    "wherever the axes stand: check direction and location of <spindle> and <workholding>, or give "
		    "one of them checked=\"reason\"",
		    doubt->value);
		break;
	case DOUBT_SPINDLE_BESIDE:
		strbuf_addf(out,
			    "no circle of the bodies that move with the spindle has its middle on the spindle's "
			    "line: the nearest one, %.5g mm wide, is %.4g mm beside it; check the location and the "
			    "direction of <spindle>, or give it checked=\"reason\"",
			    doubt->limit, doubt->value);
		break;
	case DOUBT_SPINDLE_FAR:
		strbuf_addf(out, "the spindle's gauge point is %.4g mm away from the nearest body that moves with it (",
			    doubt->value);
		add_name(out, scene, doubt->body);
		strbuf_addf(out,
			    "): check its location and the units of the mesh, or give <spindle checked=\"reason\">");
		break;
	case DOUBT_WORKHOLDING_FAR:
		strbuf_addf(out, "the workholding is %.4g mm away from the nearest body that moves with it (",
			    doubt->value);
		add_name(out, scene, doubt->body);
		strbuf_addf(
		    out, "): check its location and the units of the mesh, or give <workholding checked=\"reason\">");
		break;
	case DOUBT_WORKHOLDING_BESIDE:
		strbuf_addf(out,
			    "the tool comes no nearer than %.4g mm to the workholding sideways: check the location of "
			    "<workholding>, of <spindle> and the limits, or give one of them checked=\"reason\"",
			    doubt->value);
		break;
	case DOUBT_BODIES_SMALL:
	case DOUBT_BODIES_LARGE:
		strbuf_addf(out,
			    "all bodies of the machine together are %.4g mm large, but its longest travel is %.4g mm: "
			    "the meshes may have other units than the file (<body units=\"inch\">, \"cm\" or \"m\")",
			    doubt->value, doubt->limit);
		break;
	default:
		break;
	}
}

static void add_travel_doubt(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	const char *name = scene->machine->axes[doubt->axis].name;

	if (doubt->kind == DOUBT_TRAVEL_ENDLESS)
		strbuf_addf(out,
			    "axis %s has no end of its travel, though other linear axes have: no position of it is "
			    "refused, and a limit_min or limit_max may be missing",
			    name);
	else
		strbuf_addf(out, "axis %s has a travel of %.5g mm, but all bodies together reach over %.5g mm along it: "
				 "check its limits and the units of the meshes",
			    name, doubt->value, doubt->limit);
	strbuf_addf(out, ", or say why it is right: <axis name=\"%s\" checked=\"reason\">", name);
}

static void add_joint_doubt(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	add_name(out, scene, doubt->body);
	strbuf_addf(out, " and ");
	add_name(out, scene, doubt->against);
	if (doubt->kind == DOUBT_EXCUSED_APART) {
		strbuf_addf(out,
			    " are excused as neighbours, but are about %.4g mm apart: adjacent_within=\"\" of <pairs> "
			    "is too large; lower it, and name pairs of a joint with <pair ... check=\"never\" "
			    "reason=\"\"/>",
			    doubt->value);
		return;
	}
	strbuf_addf(out,
		    " are about %.4g mm apart at home, and nothing else joins axis %s to what carries it: a <body> is "
		    "missing, drawn elsewhere or in other units, or say why it is right: <axis name=\"%s\" "
		    "checked=\"reason\">",
		    doubt->value, scene->machine->axes[doubt->axis].name, scene->machine->axes[doubt->axis].name);
}

static void add_missing_doubt(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	switch (doubt->kind) {
	case DOUBT_SPINDLE_BARE:
		strbuf_addf(out, "no body moves with the spindle, so that no head is checked: a <body> is missing or on "
				 "another axis, or give <spindle checked=\"reason\">");
		break;
	case DOUBT_WORKHOLDING_BARE:
		strbuf_addf(out, "no body moves with the workholding, so that no table is checked: a <body> is missing "
				 "or on another axis, or give <workholding checked=\"reason\">");
		break;
	case DOUBT_BASE_BARE:
		strbuf_addf(out, "no body stands still, so that no bed is checked: a <body> of <base> is missing or on "
				 "an axis, or give <base checked=\"reason\">");
		break;
	case DOUBT_GAP:
	case DOUBT_EXCUSED_APART:
		add_joint_doubt(out, scene, doubt);
		break;
	default:
		add_travel_doubt(out, scene, doubt);
		break;
	}
}

static void add_checked_body(struct strbuf *out)
{
	strbuf_addf(out, ", or give it checked=\"reason\"");
}

static void add_part_doubt(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	add_name(out, scene, doubt->body);
	switch (doubt->kind) {
	case DOUBT_FLOATS:
		strbuf_addf(out, " touches nothing that could hold it: %.4g mm to ", doubt->value);
		add_name(out, scene, doubt->against);
		strbuf_addf(out, "; check its location and units");
		break;
	case DOUBT_SINKS:
		strbuf_addf(out, " stands %.4g mm deep in ", doubt->value);
		add_name(out, scene, doubt->against);
		strbuf_addf(out, "; check its location, rotation and units");
		break;
	case DOUBT_OUT_OF_STOCK:
		strbuf_addf(out, " stands %.4g mm out of ", doubt->value);
		add_name(out, scene, doubt->against);
		strbuf_addf(out, ", from which it is cut; check location, size and units of both");
		break;
	case DOUBT_PART_LARGE:
		strbuf_addf(out, " is %.5g mm large, but the machine's longest travel is %.5g mm; check its units",
			    doubt->value, doubt->limit);
		break;
	case DOUBT_PART_SMALL:
		strbuf_addf(out,
			    " is only %.4g mm large, but the machine's longest travel is %.5g mm; check its units (STL "
			    "has none: "
			    "units=\"inch\", \"cm\" or \"m\")",
			    doubt->value, doubt->limit);
		break;
	case DOUBT_PART_BELOW_CUTTERS:
		strbuf_addf(
		    out,
		    " is only %.4g mm large, less than the thinnest cutter (%.4g mm); check its units (STL has none: "
		    "units=\"inch\", \"cm\" or \"m\")",
		    doubt->value, doubt->limit);
		break;
	default:
		strbuf_addf(out,
			    " is out of reach: the tip of every tool stays %.4g mm away from it, wherever the axes "
			    "stand; check "
			    "its location and the limits",
			    doubt->value);
		break;
	}
	add_checked_body(out);
}

static void add_tool_doubt(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	strbuf_addf(out, "tool %d ", scene->setup->tools[doubt->item].number);
	switch (doubt->kind) {
	case DOUBT_TOOL_BARE:
		if (doubt->value > 0)
			strbuf_addf(out, "and %.0f more have", doubt->value);
		else
			strbuf_addf(out, "has");
		strbuf_addf(out, " no <holder>, which is what collides first; describe it");
		break;
	case DOUBT_HOLDER_TURNED:
		strbuf_addf(out,
			    "has a holder that is only %.4g mm thick at the gauge line, but %.4g mm farther down: "
			    "sections stack from the gauge line to the tip; check their order",
			    doubt->value, doubt->limit);
		break;
	case DOUBT_TOOL_ENDS:
		strbuf_addf(out,
			    "is %.5g mm long, but its bodies end %.4g mm below the gauge line: a mesh has the gauge "
			    "point at its origin and the tip toward -Z; check its place, direction and units",
			    doubt->limit, doubt->value);
		break;
	case DOUBT_TOOL_ASIDE:
		strbuf_addf(out, "is drawn beside the spindle's line: the middle of ");
		add_name(out, scene, doubt->body);
		strbuf_addf(out,
			    " is %.4g mm off it; a mesh has the gauge point at its origin and the tip toward -Z",
			    doubt->value);
		break;
	case DOUBT_RADIUS_OFFSET:
		strbuf_addf(out,
			    "has a diameter of %.4g mm, but the radius of its D is %.4g mm: check that it is "
			    "no diameter",
			    doubt->limit, doubt->value);
		break;
	case DOUBT_TOOL_SHORT:
		strbuf_addf(
		    out,
		    "cannot reach the part: its tip stays %.4g mm above it; check the tool's length and the limits",
		    doubt->value);
		break;
	case DOUBT_TOOL_BELOW:
		strbuf_addf(
		    out,
		    "is too long: even at its highest position its tip is %.4g mm below all that is set up; check its "
		    "length and units",
		    doubt->value);
		break;
	case DOUBT_TOOL_LONG:
		strbuf_addf(
		    out,
		    "is %.5g mm long, more than the travel along the spindle (%.5g mm); check its length and units",
		    doubt->value, doubt->limit);
		break;
	case DOUBT_TOOL_TINY:
		strbuf_addf(
		    out,
		    "is only %.4g mm long, though the travel along the spindle is %.5g mm; check its length and units",
		    doubt->value, doubt->limit);
		break;
	default:
		strbuf_addf(out,
			    "is %.5g mm long, but its length offset is %.5g mm: with G43 its tip is %.4g mm from where "
			    "the program "
			    "takes it to be; check length_offset",
			    doubt->limit, doubt->value, fabs(doubt->value - doubt->limit));
		break;
	}
	add_checked_body(out);
}

static void add_offset_doubt(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	const struct work_offset *offset = &scene->setup->offsets[doubt->item];

	if (doubt->kind == DOUBT_OFFSET_OUTSIDE) {
		const struct axis *axis = &scene->machine->axes[doubt->axis];
		const char *unit = format_units_unit(axis->slot);

		strbuf_addf(out, "work offset %s has %s %.6g %s, outside the axis' travel (%.6g to %.6g %s)",
			    offset->name, axis->name, format_units_value(axis->slot, doubt->value), unit,
			    format_units_value(axis->slot, axis->limit_min),
			    format_units_value(axis->slot, axis->limit_max), unit);
	} else {
		strbuf_addf(out, "work offset %s is %.4g mm away from all that is set up (which is %.4g mm large)",
			    offset->name, doubt->value, doubt->limit);
	}
	strbuf_addf(out, "; check its values, their signs and units");
	add_checked_body(out);
}

void doubt_text_add(struct strbuf *out, const struct scene *scene, const struct doubt *doubt)
{
	if (doubt->kind == DOUBT_LEFT_HANDED)
		strbuf_addf(out,
			    "X Y Z of the tool against the work are left-handed: a sign is wrong or two letters are "
			    "exchanged; check the directions, or give one of the axes checked=\"reason\"");
	else if (doubt->kind == DOUBT_TURNED)
		strbuf_addf(
		    out,
		    "X Y Z of the tool against the work are not those of the drawing: check the letters, or give one "
		    "of the axes checked=\"reason\"");
	else if (doubt->kind <= DOUBT_SPINDLE_TOWARD)
		add_axis_doubt(out, scene, doubt);
	else if (doubt->kind <= DOUBT_BODIES_LARGE)
		add_place_doubt(out, scene, doubt);
	else if (doubt->kind <= DOUBT_TRAVEL_ENDLESS)
		add_missing_doubt(out, scene, doubt);
	else if (doubt->kind <= DOUBT_PART_BESIDE)
		add_part_doubt(out, scene, doubt);
	else if (doubt->kind <= DOUBT_LENGTH_OFFSET)
		add_tool_doubt(out, scene, doubt);
	else
		add_offset_doubt(out, scene, doubt);
}
