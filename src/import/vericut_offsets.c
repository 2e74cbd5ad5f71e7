#include "import/vericut_offsets.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/same_double.h"
#include "machine/xml/foreign_xml.h"
#include "machine/xml/xml_element.h"

/* mm: the values that VERICUT stored for From and To may be rounded. */
#define SAME_PLACE 0.01

struct reading {
	struct import_setup *setup;
	const struct import_machine *machine;
	const struct vericut_components *components;
	struct xml_reader *xml;
	const xmlNode *setup_node;
};

/* A warning at the element, and a note for the setup file. */
static void warn(const struct reading *r, const xmlNode *node, const char *what)
{
	diag_warning(r->xml->diag, (struct srcloc){.file = r->xml->path, .line = xml_line(r->xml, node)}, "%s", what);
	import_machine_todo(&r->setup->bodies, "%s", what);
}

/* -------------------------------------------------------------------- places */

/* The frame of a component of the setup, or of the mount of the work, relative to the mount. False: it is neither. */
static bool component_frame(const struct reading *r, const char *name, xform *frame)
{
	const struct vericut_component *component = vericut_components_find(r->components, name);

	*frame = component ? component->frame : xform_identity();
	return component || (r->machine->work_name && !strcmp(name, r->machine->work_name));
}

static const xmlNode *find_system(const struct reading *r, const char *name)
{
	const xmlNode *at = foreign_child(foreign_child(r->setup_node, "CSystems"), "CSystem");

	while (at && !foreign_attribute_is(at, "Name", name))
		at = foreign_next(at, "CSystem");
	return at;
}

/*
 * The place of <To>, relative to the mount of the work. *known: false if its system is attached to something that does
 * not belong to the setup. False: reported.
 */
static bool read_place(const struct reading *r, const xmlNode *to, vec3 *place, bool *known)
{
	struct arena *arena = &r->setup->bodies.description.arena;
	const char *name = foreign_text(arena, to);
	xform frame = xform_identity(), local = frame;
	vec3 more = {0, 0, 0};

	if (foreign_attribute_is(to, "CSystem", "on")) {
		const xmlNode *system = find_system(r, name);

		if (system && !vericut_frame(r->xml, system, &local))
			return false;
		name = system ? foreign_text(arena, foreign_child(system, "Attach")) : "";
	}
	*known = component_frame(r, name, &frame);
	if (foreign_attribute(to, "X") && !foreign_vector(r->xml, to, "X", "Y", "Z", &more))
		return false;
	frame = xform_mul(&frame, &local);
	*place = xform_apply(&frame, vec3_scale(r->xml->unit, more));
	return true;
}

/* ---------------------------------------------------------------------- axes */

/*
 * The direction in which the tool moves relative to the work for a positive value of the axis; NULL: the machine does
 * not have it.
 */
static const struct axis_description *axis_of(const struct import_machine *machine, int slot, vec3 *direction)
{
	const struct machine_description *d = &machine->description;

	for (size_t i = 0; i < d->axis_count; i++) {
		bool carries_work = false;

		if (d->axes[i].slot != slot)
			continue;
		for (int link = d->workholdings[0].link; link > 0; link = d->axes[link - 1].parent)
			carries_work |= link == 1 + (int)i;
		*direction = vec3_scale(carries_work ? -1 : 1, d->axes[i].direction);
		return &d->axes[i];
	}
	return NULL;
}

/* The values of X, Y and Z that bring the gauge point to the place. False: the axes are not perpendicular. */
static bool reach(const struct import_machine *machine, vec3 way, double values[3])
{
	vec3 left = way;

	for (int slot = 0; slot < 3; slot++) {
		vec3 direction;

		values[slot] = 0;
		if (!axis_of(machine, slot, &direction))
			continue;
		values[slot] = vec3_dot(way, direction);
		left = vec3_sub(left, vec3_scale(values[slot], direction));
	}
	return vec3_norm(left) < 1e-6 * (1 + vec3_norm(way));
}

/* ---------------------------------------------------------------------- rows */

/* "G54" to "G59" for the registers 54 to 59 and 1 to 6; NULL: none. */
static const char *name_of(const char *index)
{
	static const char *const names[] = {"G54", "G55", "G56", "G57", "G58", "G59"};
	char *end;
	const long number = strtol(index, &end, 10), n = number >= 54 ? number - 54 : number - 1;

	return *index && !*end && n >= 0 && n < 6 ? names[n] : NULL;
}

/*
 * Do the values that VERICUT stored match From and To? From is the gauge point; otherwise the comparison is not
 * possible.
 */
static bool check_values(const struct reading *r, const xmlNode *row, const double values[3])
{
	const xmlNode *at = foreign_child(row, "Value");
	struct strbuf text = {0};

	for (int i = 0; i < 3 && at; i++, at = foreign_next(at, "Value")) {
		double stored;

		if (!foreign_number(r->xml, at, NULL, &stored))
			return false;
		if (fabs(r->xml->unit * stored - values[i]) > SAME_PLACE && !text.length)
			strbuf_addf(&text,
				    "%c of a work offset is %.10g in the file, but From and To are %.10g mm apart: "
				    "From and To are used; compare them",
				    "XYZ"[i], stored, values[i]);
	}
	if (text.length)
		warn(r, row, strbuf_text(&text));
	strbuf_release(&text);
	return true;
}

/* Does the element have a value other than 0 that is not imported? */
static bool has_values(const xmlNode *node)
{
	static const char *const names[] = {"X", "Y", "Z", "A", "B", "C", "U", "V", "W", "A2", "B2", "C2"};

	for (size_t i = 0; node && i < sizeof(names) / sizeof(*names); i++) {
		const char *text = foreign_attribute(node, names[i]);

		if (text && (strtod(text, NULL) > 0 || strtod(text, NULL) < 0))
			return true;
	}
	return false;
}

/* Does the file have a value other than 0 after those of X, Y and Z: an offset of a rotary or a parallel axis? */
static bool has_more_values(const struct reading *r, const xmlNode *row)
{
	int count = 0;

	for (const xmlNode *at = foreign_child(row, "Value"); at; at = foreign_next(at, "Value"), count++)
		if (count >= 3 && fabs(strtod(foreign_text(&r->setup->bodies.description.arena, at), NULL)) > 0)
			return true;
	return false;
}

/* Only axes that the machine has get a value. */
static void add_offset(const struct reading *r, const char *name, const double values[3])
{
	struct work_offset_description *offset = &r->setup->offsets[r->setup->offset_count++];
	vec3 direction;

	*offset = (struct work_offset_description){.name = name};
	for (int slot = 0; slot < 3; slot++)
		if (axis_of(r->machine, slot, &direction))
			offset->value[slot] = (struct optional_number){true, values[slot]};
}

static bool is_taken(const struct import_setup *setup, const char *name)
{
	for (size_t i = 0; i < setup->offset_count; i++)
		if (!strcmp(setup->offsets[i].name, name))
			return true;
	return false;
}

/* Adds the offset, or notes why it was not added. False: reported. */
static bool take_row(const struct reading *r, const xmlNode *table, const xmlNode *row, const double values[3])
{
	const char *index = foreign_attribute(row, "Index") ? foreign_attribute(row, "Index") : "";
	const char *kind = foreign_attribute(table, "Name");
	const char *name = ascii_same(kind, "Work Offsets") ? name_of(index) : NULL;
	struct strbuf text = {0};

	if (!name || is_taken(r->setup, name))
		strbuf_addf(&text,
			    "Row %s of the table %s has no name here: its position is X%.10g Y%.10g Z%.10g; add it as "
			    "a work offset that the program selects.",
			    xml_quote(index).text, xml_quote(kind).text, values[0], values[1], values[2]);
	else if (strlen(index) < 2)
		strbuf_addf(&text,
			    "Register %s of the work offsets is assumed to be %s: compare with the control.", index,
			    name);
	if (text.length)
		warn(r, row, strbuf_text(&text));
	if (name && !is_taken(r->setup, name))
		add_offset(r, name, values);
	strbuf_release(&text);
	return true;
}

static bool read_row(const struct reading *r, const xmlNode *table, const xmlNode *row)
{
	const struct machine_description *d = &r->machine->description;
	struct arena *arena = &r->setup->bodies.description.arena;
	const xmlNode *from = foreign_child(row, "From"), *to = foreign_child(row, "To");
	const char *start = foreign_text(arena, from);
	bool known = false;
	double values[3];
	vec3 place;

	if (!from || !to || !d->spindle_count || !d->workholding_count ||
	    has_values(foreign_child(row, "AddOffset")) || has_values(foreign_child(row, "RelPosition")) ||
	    has_more_values(r, row)) {
		warn(r, row, "A work offset is not converted, because not only From and To define it: add it.");
		return true;
	}
	if (!read_place(r, to, &place, &known))
		return false;
	place = xform_apply(&d->workholdings[0].frame, place);
	if (!known || !reach(r->machine, vec3_sub(place, d->spindles[0].location), values)) {
		warn(r, row, "A work offset is not converted, because its position is not on the work: add it.");
		return true;
	}
	if (!r->machine->tool_name || strcmp(start, r->machine->tool_name) != 0 || has_values(from))
		warn(r, row,
		     "In the file, a work offset is not relative to the gauge point; here it is, as are tool lengths.");
	else if (!check_values(r, row, values))
		return false;
	return take_row(r, table, row, values);
}

static bool is_table(const xmlNode *table, const char *name)
{
	return foreign_attribute_is(table, "Name", name);
}

/* Tables that define the program's zero. */
static bool is_offset_table(const xmlNode *table)
{
	static const char *const names[] = {"Work Offsets", "Program Zero", "Input Program Zero"};

	for (size_t i = 0; i < sizeof(names) / sizeof(*names); i++)
		if (is_table(table, names[i]))
			return true;
	return false;
}

/*
 * All work offsets are relative to the base work offset. In this case the meaning of From and To of the others is
 * unknown, so a row of the base offset with any value other than 0 makes them uncertain.
 */
static const xmlNode *find_base(const struct reading *r, const xmlNode *first)
{
	struct arena *arena = &r->setup->bodies.description.arena;

	for (const xmlNode *table = first; table; table = foreign_next(table, "Table")) {
		if (!is_table(table, "Base Work Offset"))
			continue;
		for (const xmlNode *row = foreign_child(table, "Row"); row; row = foreign_next(row, "Row")) {
			const xmlNode *value = foreign_child(row, "Value");
			bool zero = value != NULL && !has_values(foreign_child(row, "AddOffset")) &&
				    !has_values(foreign_child(row, "RelPosition"));

			for (; value; value = foreign_next(value, "Value")) {
				char *end;

				zero &= same_double(strtod(foreign_text(arena, value), &end), 0) && !*end;
			}
			if (!zero)
				return row;
		}
	}
	return NULL;
}

/* Tables of the control that have rows but are not imported: lengths of tools, shifts, pivots. */
static void note_other(const struct reading *r, const xmlNode *table)
{
	struct strbuf text = {0};

	if (is_table(table, "Base Work Offset") || !foreign_child(table, "Row"))
		return;
	strbuf_addf(&text, "The table %s of the setup is not converted: compare its contents with the control.",
		    xml_quote(foreign_attribute(table, "Name") ? foreign_attribute(table, "Name") : "").text);
	warn(r, table, strbuf_text(&text));
	strbuf_release(&text);
}

bool vericut_offsets_read(struct import_setup *setup, const struct import_machine *machine,
			  const struct vericut_components *components, struct xml_reader *xml, const xmlNode *node)
{
	const struct reading r = {setup, machine, components, xml, node};
	const xmlNode *first = foreign_child(foreign_child(node, "GCode"), "Table"), *base = find_base(&r, first);

	/* As many as there are possible names. */
	setup->offsets = arena_alloc(&setup->bodies.description.arena, 6 * sizeof(*setup->offsets));
	if (base)
		warn(&r, base,
		     "The setup has a base work offset, to which all others are relative: no work offset is converted. "
		     "Add them as in the control.");
	for (const xmlNode *table = first; table; table = foreign_next(table, "Table")) {
		if (!is_offset_table(table)) {
			note_other(&r, table);
			continue;
		}
		for (const xmlNode *row = base ? NULL : foreign_child(table, "Row"); row;
		     row = foreign_next(row, "Row"))
			if (!read_row(&r, table, row))
				return false;
	}
	return true;
}
