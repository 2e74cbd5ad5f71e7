#include "import/vericut_machine.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "base/axes.h"
#include "base/math/math_functions.h"
#include "import/vericut_components.h"
#include "import/vericut_model.h"
#include "import/vericut_pairs.h"
#include "machine/xml/foreign_xml.h"
#include "machine/xml/xml_element.h"

struct reading {
	struct import_machine *machine;
	const struct import_options *options;
	struct xml_reader xml;
	const struct vericut_build *build;	/* of the setup whose machine this is, or NULL */
	struct vericut_components components;
	struct diag *diag;
};

/* `xml`: the reader of the file with the node. */
static void warn(const struct xml_reader *xml, const xmlNode *node, const char *format, ...)
	__attribute__((format(printf, 3, 4)));

static void warn(const struct xml_reader *xml, const xmlNode *node, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	diag_report(xml->diag, DIAG_WARNING, (struct srcloc){.file = xml->path, .line = xml_line(xml, node)}, NULL,
		    format, args);
	va_end(args);
}

/* -------------------------------------------------------------------- axes */

/* A unit vector of the component's own frame, from X, -X, Y and so on, in machine coordinates. */
static bool axis_direction(const struct vericut_component *c, const xmlNode *link, vec3 *direction)
{
	const char *word = foreign_attribute(link, "Axis");
	double sense = 1;

	if (word && (*word == '-' || *word == '+'))
		sense = *word++ == '-' ? -1 : 1;
	if (!word || strlen(word) != 1 || !strchr("XYZxyz", *word)) {
		xml_error(c->xml, link, "Axis", "the Axis of '%s' must be X, Y or Z, with or without a sign",
			  xml_quote(c->name).text);
		return false;
	}
	switch (ascii_upper(*word)) {
	case 'X':
		*direction = vec3_scale(sense, c->frame.rotation.x);
		break;
	case 'Y':
		*direction = vec3_scale(sense, c->frame.rotation.y);
		break;
	default:
		*direction = vec3_scale(sense, c->frame.rotation.z);
	}
	return true;
}

/*
 * Does the axis move in the negative direction, because it carries the work? DisableAuto ("off") of version 7.0 became
 * PartSide ("auto") in 7.1.
 */
static bool is_reversed(const struct vericut_component *c, const xmlNode *link, bool *reversed)
{
	const char *disabled = foreign_attribute(link, "DisableAuto"), *side = foreign_attribute(link, "PartSide");

	if (side && !ascii_same(side, "auto")) {
		xml_error(
		    c->xml, link, "PartSide",
		    "PartSide=\"%s\" of '%s' is not supported, only \"auto\"; write the direction of the axis for a "
		    "positive value into machine.xml by hand",
		    xml_quote(side).text, xml_quote(c->name).text);
		return false;
	}
	*reversed = c->carries_work && !(disabled && ascii_same(disabled, "on"));
	return true;
}

/* The slot of the control's axis that moves the component, from Register. -1: there is none. */
static int slot_of(const xmlNode *link)
{
	const char *name = foreign_attribute(link, "Register");
	const char *letter = name && strlen(name) == 1 ? strchr(AXIS_LETTERS, ascii_upper(*name)) : NULL;

	return letter ? (int)(letter - AXIS_LETTERS) : -1;
}

/* <TlRecord>: the travel. Of several conditional ones, the widest is used. */
static bool read_travel(struct xml_reader *xml, const xmlNode *link, struct axis_description *axis)
{
	const double scale = axis->rotary ? math_acos(-1) / 180 : xml->unit;
	const xmlNode *record = foreign_child(link, "TlRecord");
	bool several = record && foreign_next(record, "TlRecord");
	double least = INFINITY, greatest = -INFINITY, low, high;

	axis->limit_min = -INFINITY;
	axis->limit_max = INFINITY;
	if (several)
		warn(xml, record, "%c has several travels with conditions: the widest is used",
		     AXIS_LETTERS[axis->slot]);
	for (; record; record = foreign_next(record, "TlRecord")) {
		if (foreign_attribute_is(record, "TlIgnore", "on")) {
			warn(xml, record, "the travel of %c is switched off in this file: the axis gets no limits",
			     AXIS_LETTERS[axis->slot]);
			return true;
		}
		if (!foreign_number(xml, record, "TlMin", &low) || !foreign_number(xml, record, "TlMax", &high))
			return false;
		least = fmin(least, low);
		greatest = fmax(greatest, high);
	}
	if (least > greatest) {
		warn(xml, link, "%c has no travel in this file: the axis gets no limits", AXIS_LETTERS[axis->slot]);
		return true;
	}
	axis->limit_min = scale * least;
	axis->limit_max = scale * greatest;
	return true;
}

/* mm or degrees a minute. 0: the file has no rate. */
static bool read_rate(struct xml_reader *xml, const xmlNode *link, struct axis_description *axis)
{
	double rate = 0;

	if (foreign_attribute(link, "RapidRate") && !foreign_number(xml, link, "RapidRate", &rate))
		return false;
	axis->rate_max = rate > 0 ? rate * (axis->rotary ? 1 : xml->unit) : 0;
	return true;
}

static bool add_axis(struct reading *r, struct vericut_component *c, const xmlNode *link, int slot)
{
	struct machine_description *d = &r->machine->description;
	struct axis_description *axis = &d->axes[d->axis_count];
	bool reversed;

	*axis = (struct axis_description){
		.slot = slot,
		.rotary = ascii_same(c->type, "rotary"),
		.parent = c->link,
		.location = c->frame.translation,
	};
	axis->has_location = axis->rotary;
	if (axis->rotary != slot_is_rotary(slot)) {
		xml_error(c->xml, c->node, "Type", "the component '%s' is %s, but its register is %c",
			  xml_quote(c->name).text, axis->rotary ? "rotary" : "linear", AXIS_LETTERS[slot]);
		return false;
	}
	for (size_t i = 0; i < d->axis_count; i++) {
		if (d->axes[i].slot != slot)
			continue;
		xml_error(c->xml, link, "Register",
			  "'%s' is the second component with the register %c; fivecheck moves only one for each letter",
			  xml_quote(c->name).text, AXIS_LETTERS[slot]);
		return false;
	}
	if (!axis_direction(c, link, &axis->direction) || !is_reversed(c, link, &reversed) ||
	    !read_travel(c->xml, link, axis) || !read_rate(c->xml, link, axis))
		return false;
	if (reversed)
		axis->direction = vec3_scale(-1, axis->direction);
	if (strcmp(c->name, (const char[]){AXIS_LETTERS[slot], 0}) != 0)
		axis->title = arena_strdup(&d->arena, c->name);
	c->slot = slot;
	c->link = 1 + (int)d->axis_count++;
	return true;
}

/* A component without a register of the control stays where it is drawn. */
static bool read_axis(struct reading *r, struct vericut_component *c)
{
	const xmlNode *link = foreign_child(c->node, "Link");
	bool linear = ascii_same(c->type, "linear"), rotary = ascii_same(c->type, "rotary");
	int slot;

	c->link = c->parent ? c->parent->link : 0;
	if (!linear && !rotary)
		return true;
	slot = link ? slot_of(link) : -1;
	if (slot >= 0)
		return add_axis(r, c, link, slot);
	warn(c->xml, c->node,
	     "the component '%s' is moved by no axis of the control (X to W): it is assumed to be fixed",
	     xml_quote(c->name).text);
	return true;
}

static bool read_axes(struct reading *r)
{
	struct machine_description *d = &r->machine->description;

	d->axes = arena_alloc(&d->arena, SLOT_COUNT * sizeof(*d->axes));
	for (size_t i = 0; i < r->components.count; i++)
		if (!read_axis(r, r->components.order[i]))
			return false;
	return true;
}

/* -------------------------------------------------------------------- home */

/* The first row of a table of locations, whose first values are X, Y and Z; NULL: there is none. */
static const xmlNode *location_row(const struct reading *r, const char *name)
{
	const xmlNode *table = foreign_child(xml_root(&r->xml), "Table");

	for (; table; table = foreign_next(table, "Table")) {
		const xmlNode *row = foreign_child(table, "Row");

		if (foreign_attribute_is(table, "Name", name) && row && foreign_child(row, "Value"))
			return row;
	}
	return NULL;
}

/* The value of a linear axis in the row. False, reported: it is not a number. Without a value *value is not changed. */
static bool read_location(struct reading *r, const xmlNode *row, int slot, double *value)
{
	const xmlNode *at = row && slot <= SLOT_Z ? foreign_child(row, "Value") : NULL;

	for (int i = 0; at && i < slot; i++)
		at = foreign_next(at, "Value");
	if (!at)
		return true;
	if (!foreign_number(&r->xml, at, NULL, value))
		return false;
	*value *= r->xml.unit;
	return true;
}

/*
 * Programs start at the reference location, else at the initial one, else at 0; but within the travel. Only the first
 * three values of a location are known: those of X, Y and Z.
 */
static bool read_home(struct reading *r)
{
	const xmlNode *reference = location_row(r, "Machine Reference Location");
	const xmlNode *row = reference ? reference : location_row(r, "Initial Machine Location");

	for (size_t i = 0; i < r->machine->description.axis_count; i++) {
		struct axis_description *axis = &r->machine->description.axes[i];
		double value = 0, home;

		if (!read_location(r, row, axis->slot, &value))
			return false;
		home = fmin(fmax(value, axis->limit_min), axis->limit_max);
		if (fabs(home - value) > 0)
			warn(&r->xml, xml_root(&r->xml),
			     "%c starts beyond its travel in this file: it gets the nearer end as its home",
			     AXIS_LETTERS[axis->slot]);
		axis->home = (struct optional_number){.given = fabs(home) > 0, .value = home};
	}
	return true;
}

/* ------------------------------------------------------------------ models */

/* False: reported. */
static bool read_model(struct reading *r, const struct vericut_component *c, const xmlNode *node)
{
	struct vericut_model model;

	if (!vericut_model_read(&model, c->xml, node, c, r->options, &r->machine->description.arena))
		return false;
	r->machine->left_out += model.left_out;
	if (!model.left_out)
		import_machine_add_body(r->machine, model.name, c->name, c->link, &model.frame, &model.mesh)->at = c;
	return true;
}

static bool read_models(struct reading *r)
{
	bool good = true;

	for (size_t i = 0; i < r->components.count; i++) {
		const struct vericut_component *c = r->components.order[i];

		if (c->mounted)
			continue;
		for (const xmlNode *at = foreign_child(c->node, NULL); at; at = foreign_next(at, NULL))
			good = (!vericut_part_is_model(at) || read_model(r, c, at)) && good;
	}
	return good;
}

/* ------------------------------------------------------------------ mounts */

/* The first component of the type, with a warning if there are several; NULL: there is none. */
static const struct vericut_component *choose(const struct reading *r, const char *type)
{
	const struct vericut_component *chosen = NULL;
	size_t count = 0;

	for (size_t i = 0; i < r->components.count; i++) {
		const struct vericut_component *c = &r->components.items[i];

		if (!ascii_same(c->type, type))
			continue;
		if (!count++)
			chosen = c;
	}
	if (count > 1)
		warn(chosen->xml, chosen->node, "there are %zu components of the type %s: only '%s' is used",
		     count, type, xml_quote(chosen->name).text);
	return chosen;
}

/* The carrier of the work; NULL: there is none. A setup defines it. */
static const struct vericut_component *find_work(const struct reading *r)
{
	const struct vericut_component *mount = NULL;

	if (r->build && r->build->mount)
		mount = vericut_components_find(&r->components, r->build->mount);
	return mount ? mount : choose(r, "attach");
}

/* Tools are mounted with their gauge point at the component's origin, and point opposite to its Z. */
static void read_mounts(struct reading *r)
{
	struct machine_description *d = &r->machine->description;
	const struct vericut_component *tool = choose(r, "tool"), *work = find_work(r);

	if (tool) {
		d->spindles = arena_alloc(&d->arena, sizeof(*d->spindles));
		d->spindles[d->spindle_count++] = (struct spindle_description){
			.link = tool->link,
			.location = tool->frame.translation,
			.direction = vec3_scale(-1, tool->frame.rotation.z),
		};
		r->machine->tool_name = arena_strdup(&d->arena, tool->name);
	} else {
		warn(&r->xml, xml_root(&r->xml),
		     "the machine has no component of the type tool: no tool can be mounted");
	}
	if (work) {
		d->workholdings = arena_alloc(&d->arena, sizeof(*d->workholdings));
		d->workholdings[d->workholding_count++] =
			(struct workholding_description){.link = work->link, .frame = work->frame};
		r->machine->work_name = arena_strdup(&d->arena, work->name);
	} else {
		warn(&r->xml, xml_root(&r->xml),
		     "the machine has no component of the type attach: no work can be mounted");
	}
}

/*
 * Bodies that a setup attaches to the machine beside the work are checked against everything that moves relative to
 * them, like fixtures. Without these pairs the bodies of a neighbouring link might be excused.
 */
static void add_pairs_of_setup(struct reading *r)
{
	const struct machine_description *d = &r->machine->description;

	for (size_t i = 0; i < d->body_count; i++) {
		const struct vericut_component *c = d->bodies[i].at;
		const int link = d->bodies[i].link, parent = link ? d->axes[link - 1].parent : 0;

		if (!c->of_setup || c->slot >= 0)
			continue;
		for (size_t k = 0; k < d->axis_count; k++)
			if (d->axes[k].parent == link || parent == 1 + (int)k)
				import_machine_add_pair(r->machine, d->bodies[i].name,
							vericut_axis_names[d->axes[k].slot], 0);
		if (link && !parent)
			import_machine_add_pair(r->machine, d->bodies[i].name, "base", 0);
	}
}

static bool read_machine(struct reading *r)
{
	r->xml.unit = vericut_unit(&r->xml, xml_root(&r->xml));
	if (!(r->xml.unit > 0) ||
	    !vericut_components_read(&r->components, &r->xml, xml_root(&r->xml), r->build,
				     &r->machine->description.arena) || !read_axes(r) ||
	    !read_home(r) || !read_models(r))
		return false;
	read_mounts(r);
	add_pairs_of_setup(r);
	return vericut_pairs_read(r->machine, &r->components, &r->xml);
}

bool vericut_machine_read(struct import_machine *machine, const char *path, const struct vericut_build *build,
			  const struct import_options *options, struct diag *diag)
{
	static const char *const elements[] = {"VcMachine", NULL};
	struct reading r = {.machine = machine, .options = options, .build = build, .diag = diag};
	bool good;

	if (!xml_open(&r.xml, path, elements, diag))
		return false;
	machine->description.name = vericut_stem(&machine->description.arena, path);
	good = read_machine(&r) && !r.xml.errors;
	/* They point into the tree of the file. */
	for (size_t i = 0; i < machine->description.body_count; i++)
		machine->description.bodies[i].at = NULL;
	xml_close(&r.xml);
	return good;
}
