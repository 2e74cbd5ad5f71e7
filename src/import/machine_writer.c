#include "import/machine_writer.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/axes.h"
#include "base/math/math_functions.h"
#include "base/mem.h"
#include "base/units.h"
#include "base/utf8.h"
#include "base/xml_text.h"
#include "control/dialects.h"
#include "geom/stl_bytes.h"

/* Rates of a usual machining centre, mm and degrees a minute, for files without rates. Only times depend on them. */
#define LINEAR_RATE 30000.0
#define ROTARY_RATE 7200.0

/* A value below this, mm or degrees, is the rounding of 0. */
#define NOTHING 1e-9

/* mm per unit of the file that is written. */
static double unit_of(const struct import_machine *machine)
{
	return machine->inch ? MM_PER_INCH : 1;
}

/* Rounds values that were meant to be round: the difference is far below any tolerance. */
static double tidy(double value)
{
	double rounded = nearbyint(value * 1e6) / 1e6;

	if (fabs(value) < NOTHING)
		return 0;
	return fabs(value - rounded) < NOTHING ? rounded : value;
}

static void add_number(struct strbuf *out, const char *attribute, double value)
{
	strbuf_addf(out, " %s=\"%.15g\"", attribute, tidy(value));
}

static void add_vector(struct strbuf *out, const char *attribute, vec3 v)
{
	strbuf_addf(out, " %s=\"%.15g %.15g %.15g\"", attribute, tidy(v.x), tidy(v.y), tidy(v.z));
}

/* Directions keep all their digits: the effect of an angle error grows with the distance. */
static void add_direction(struct strbuf *out, vec3 v)
{
	const double parts[3] = {v.x, v.y, v.z};

	strbuf_addf(out, " direction=\"");
	for (int i = 0; i < 3; i++)
		strbuf_addf(out, "%s%.15g", i ? " " : "", fabs(parts[i]) < 1e-15 ? 0 : parts[i]);
	strbuf_addf(out, "\"");
}

/* fixed angles about X, Y and Z, degrees: R = Rz Ry Rx. */
static vec3 fixed_angles(const mat3 *r)
{
	/* The elements of the columns: r->x.z is in row 3, column 1. */
	double level = math_hypot(r->x.x, r->x.y);
	vec3 angles = {0, degrees(math_atan2(-r->x.z, level)), 0};

	/* If Y is +-90 degrees, X and Z rotate about the same line: Z gets the whole rotation. */
	if (level < 1e-9) {
		angles.z = degrees(math_atan2(-r->y.x, r->y.y));
		return angles;
	}
	angles.x = degrees(math_atan2(r->y.z, r->z.z));
	angles.z = degrees(math_atan2(r->x.y, r->x.x));
	return angles;
}

void machine_writer_frame(struct strbuf *out, const xform *frame, bool location_needed)
{
	vec3 angles = fixed_angles(&frame->rotation), p = frame->translation;

	if (location_needed || fabs(tidy(p.x)) + fabs(tidy(p.y)) + fabs(tidy(p.z)) > 0)
		add_vector(out, "location", p);
	if (fabs(tidy(angles.x)) + fabs(tidy(angles.y)) + fabs(tidy(angles.z)) > 0)
		add_vector(out, "rotation", angles);
}

static void indent(struct strbuf *out, int depth)
{
	strbuf_addf(out, "%*s", 2 * depth, "");
}

/* A frame with its translation in the units of the file. */
static xform frame_in(const struct import_machine *machine, const xform *frame)
{
	return (xform){frame->rotation, vec3_scale(1 / unit_of(machine), frame->translation)};
}

static void add_bodies(struct strbuf *out, const struct import_machine *machine, int link, int depth)
{
	const struct machine_description *d = &machine->description;

	for (size_t i = 0; i < d->body_count; i++) {
		const struct body_description *body = &d->bodies[i];
		const xform frame = frame_in(machine, &body->frame);

		if (body->link != link)
			continue;
		indent(out, depth);
		strbuf_addf(out, "<body");
		xml_text_attribute(out, "name", body->name);
		xml_text_attribute(out, "mesh", body->mesh_path);
		if (machine->inch)
			xml_text_attribute(out, "units", "mm");
		machine_writer_frame(out, &frame, false);
		strbuf_addf(out, "/>\n");
	}
}

static void add_mounts(struct strbuf *out, const struct import_machine *machine, int link, int depth)
{
	const struct machine_description *d = &machine->description;

	for (size_t i = 0; i < d->spindle_count; i++) {
		if (d->spindles[i].link != link)
			continue;
		indent(out, depth);
		strbuf_addf(out, "<spindle");
		add_vector(out, "location", vec3_scale(1 / unit_of(machine), d->spindles[i].location));
		add_direction(out, d->spindles[i].direction);
		strbuf_addf(out, "/>\n");
	}
	for (size_t i = 0; i < d->workholding_count; i++) {
		const xform frame = frame_in(machine, &d->workholdings[i].frame);

		if (d->workholdings[i].link != link)
			continue;
		indent(out, depth);
		strbuf_addf(out, "<workholding");
		machine_writer_frame(out, &frame, true);
		strbuf_addf(out, "/>\n");
	}
}

static void add_axis_tag(struct strbuf *out, const struct import_machine *machine, const struct axis_description *axis,
			 int depth)
{
	const double unit = unit_of(machine), scale = axis->rotary ? degrees(1) : 1 / unit;
	const double rate = axis->rate_max > 0 ? axis->rate_max : axis->rotary ? ROTARY_RATE : LINEAR_RATE;

	if (!(axis->rate_max > 0)) {
		indent(out, depth);
		strbuf_addf(out, "<!-- TODO The rapid rate is a guess: the imported file has none. -->\n");
	}
	indent(out, depth);
	strbuf_addf(out, "<axis name=\"%c\"", AXIS_LETTERS[axis->slot]);
	if (axis->title)
		xml_text_attribute(out, "title", axis->title);
	xml_text_attribute(out, "type", axis->rotary ? "rotary" : "linear");
	add_direction(out, axis->direction);
	if (axis->has_location)
		add_vector(out, "location", vec3_scale(1 / unit, axis->location));
	if (isfinite(axis->limit_min))
		add_number(out, "limit_min", scale * axis->limit_min);
	if (isfinite(axis->limit_max))
		add_number(out, "limit_max", scale * axis->limit_max);
	add_number(out, "rate_max", axis->rotary ? rate : rate / unit);
	if (axis->home.given)
		add_number(out, "home", scale * axis->home.value);
	strbuf_addf(out, ">\n");
}

static void add_link(struct strbuf *out, const struct import_machine *machine, int link, int depth);

/* The recursion is at most nine axes deep. NOLINTNEXTLINE(misc-no-recursion) */
static void add_link(struct strbuf *out, const struct import_machine *machine, int link, int depth)
{
	const struct machine_description *d = &machine->description;

	add_bodies(out, machine, link, depth);
	add_mounts(out, machine, link, depth);
	for (size_t i = 0; i < d->axis_count; i++) {
		if (d->axes[i].parent != link)
			continue;
		add_axis_tag(out, machine, &d->axes[i], depth);
		add_link(out, machine, 1 + (int)i, depth + 1);
		indent(out, depth);
		strbuf_addf(out, "</axis>\n");
	}
}

static void add_pairs(struct strbuf *out, const struct import_machine *machine)
{
	const struct machine_description *d = &machine->description;

	if (!d->pair_count)
		return;
	strbuf_addf(out,
		    "  <!-- The collision list of that file. fivecheck checks all other pairs that can meet, too. -->\n"
		    "  <pairs>\n");
	for (size_t i = 0; i < d->pair_count; i++) {
		const struct pair_description *pair = &d->pairs[i];

		strbuf_addf(out, "    <pair");
		xml_text_attribute(out, "a", pair->a);
		xml_text_attribute(out, "b", pair->b);
		xml_text_attribute(out, "check", "always");
		if (pair->clearance.value > 0)
			add_number(out, "clearance", pair->clearance.value / unit_of(machine));
		strbuf_addf(out, "/>\n");
	}
	strbuf_addf(out, "  </pairs>\n");
}

static void add_controller(struct strbuf *out, const struct import_machine *machine)
{
	const struct controller_description *controller = &machine->description.controller;

	if (!machine->dialect_known)
		strbuf_addf(
		    out,
		    "  <!-- TODO The control's dialect, and how it moves in G0: linear, dogleg (each axis at its own\n "
		    "      rate) or any (not known: every path between start and end is checked). -->\n");
	strbuf_addf(out, "  <controller");
	xml_text_attribute(out, "dialect", dialect_names[controller->told.dialect]);
	xml_text_attribute(out, "rapid", machine->rapid_known ? "linear" : "any");
	strbuf_addf(out, "/>\n");
}

void machine_writer_todo(struct strbuf *out, const struct import_machine *machine)
{
	if (machine->left_out)
		strbuf_addf(out,
			    "  <!-- TODO Bodies without a mesh file are left out (%zu): what they hit is not found. "
			    "-->\n",
			    machine->left_out);
	for (size_t i = 0; i < machine->todo_count; i++) {
		struct strbuf todo = {0};

		strbuf_addf(&todo, "TODO %s", machine->todo[i]);
		strbuf_addf(out, "  ");
		xml_text_comment(out, strbuf_text(&todo));
		strbuf_release(&todo);
	}
}

/* A machine file permits names of up to 200 bytes; a byte that is not UTF-8 becomes three. */
static void add_name(struct strbuf *out, const char *name)
{
	enum { NAME_MAX_BYTES = 200 };
	struct strbuf clean = {0};
	size_t length = 0;
	char *clipped;

	utf8_add_clean(&clean, name);
	for (const char *at = strbuf_text(&clean); at[length] && length + utf8_length(at + length) <= NAME_MAX_BYTES;)
		length += utf8_length(at + length);
	clipped = mem_strndup(strbuf_text(&clean), length);
	xml_text_attribute(out, "name", clipped);
	free(clipped);
	strbuf_release(&clean);
}

void machine_writer_xml(struct strbuf *out, const struct import_machine *machine, const char *origin)
{
	const struct machine_description *d = &machine->description;

	strbuf_addf(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
	xml_text_comment(out, origin);
	strbuf_addf(out, "<machine version=\"1\"");
	if (d->name)
		add_name(out, d->name);
	xml_text_attribute(out, "units", machine->inch ? "inch" : "mm");
	strbuf_addf(out, ">\n");
	add_controller(out, machine);
	machine_writer_todo(out, machine);
	strbuf_addf(out, "  <base>\n");
	add_link(out, machine, 0, 2);
	strbuf_addf(out, "  </base>\n");
	add_pairs(out, machine);
	strbuf_addf(out, "</machine>\n");
}

/* --------------------------------------------------------------------- STL */

void machine_writer_stl(struct strbuf *out, const struct mesh *mesh)
{
	unsigned char head[STL_HEAD_BYTES], bytes[STL_TRIANGLE_BYTES];

	stl_bytes_head(head, "fivecheck import, binary STL, mm", (uint32_t)mesh->count);
	strbuf_add(out, (const char *)head, sizeof(head));
	for (size_t i = 0; i < mesh->count; i++) {
		stl_bytes_triangle(bytes, &mesh->triangles[i]);
		strbuf_add(out, (const char *)bytes, sizeof(bytes));
	}
}
