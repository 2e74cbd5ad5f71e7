#include "machine/machine.h"

#include <math.h>
#include <string.h>

#include "base/mem.h"
#include "base/units.h"
#include "control/dialects.h"
#include "machine/xml/body_xml.h"
#include "machine/xml/place_xml.h"
#include "machine/xml/setup_xml.h"
#include "machine/xml/xml_read.h"

/* Rates in mm or degrees a minute that are believed. */
#define RATE_MIN 1e-6
#define RATE_MAX 1e9
#define ADJACENT_WITHIN 5.0
#define MCODE_MAX 999
/* Fanuc's increment systems are IS-A (0.01) to IS-E (0.000001). */
#define LEAST_INPUT_MIN 1e-6
#define LEAST_INPUT_MAX 1.0

static void read_mcode(struct xml_reader *xml, const xmlNode *node, struct mcode *mcodes, size_t *count)
{
	static const char *const actions[] = {"tcp-on", "tcp-off", "ignore", NULL};
	size_t errors = xml->errors;
	int number = xml_integer(xml, node, "number", 0, 0, MCODE_MAX);

	if (xml->errors > errors)
		return;
	/* Stops, ends, spindle, coolant, tool change and calls: every control agrees on these. */
	if (number <= 9 || number == 30 || number == 98 || number == 99) {
		xml_error(xml, node, "M%d has a fixed meaning that cannot be changed", number);
		return;
	}
	for (size_t i = 0; i < *count; i++) {
		if (mcodes[i].number == number) {
			xml_error(xml, node, "M%d is given twice", number);
			return;
		}
	}
	mcodes[(*count)++] = (struct mcode){number, (enum mcode_action)xml_choice(node, "action", actions)};
}

static void read_length_moves(struct xml_reader *xml, const xmlNode *node, struct controller *controller)
{
	static const char *const answers[] = {"", "yes", "no", NULL};
	const struct dialect_row *row = &dialect_rows[controller->dialect];

	if (!xml_attribute(node, "length_offset_moves"))
		return;
	controller->length_moves = (enum answer)xml_choice(node, "length_offset_moves", answers);
	if (!row->has_parameters)
		xml_error(xml, node, "length_offset_moves of <controller>: %s moves no axis then", row->title);
}

static void read_controller(struct xml_reader *xml, const xmlNode *node, struct machine *machine)
{
	static const char *const rapids[] = {"linear", "dogleg", "any", NULL};
	static const char *const zeros[] = {"machine", "offset", NULL};
	struct controller *controller = &machine->controller;
	struct mcode *mcodes = arena_alloc(&machine->arena, xml_count(node, "mcode") * sizeof(*mcodes));

	controller->dialect = xml_choice(node, "dialect", dialect_names);
	controller->rapid = (enum rapid)xml_choice(node, "rapid", rapids);
	controller->tcp_zero_offset = xml_choice(node, "tcp_zero", zeros) == 1;
	controller->path_tolerance = xml_length(xml, node, "path_tolerance", 0);
	if (xml_attribute(node, "path_tolerance") && controller->path_tolerance <= 0)
		xml_error(xml, node, "path_tolerance of <controller> must be more than 0");
	controller->least_input = xml_number(xml, node, "least_input", 0);
	if (xml_attribute(node, "least_input") && !(controller->least_input >= LEAST_INPUT_MIN &&
						    controller->least_input <= LEAST_INPUT_MAX))
		xml_error(xml, node, "least_input=\"%s\" of <controller> is not between 1e-6 and 1",
			  xml_quote(xml_attribute(node, "least_input")).text);
	if (xml_attribute(node, "least_input") && !dialect_rows[controller->dialect].has_parameters)
		xml_error(xml, node, "least_input of <controller>: %s has no least input increment",
			  dialect_rows[controller->dialect].title);
	read_length_moves(xml, node, controller);
	for (const xmlNode *child = xml_first(node); child; child = xml_next(child)) {
		if (xml_is(child, "mcode"))
			read_mcode(xml, child, mcodes, &controller->mcode_count);
	}
	controller->mcodes = mcodes;
}

/* A position or limit in the axis' own unit. */
static double read_position(struct xml_reader *xml, const xmlNode *node, const char *name, bool rotary,
			    double fallback)
{
	return rotary ? xml_angle(xml, node, name, fallback) : xml_length(xml, node, name, fallback);
}

static void read_travel(struct xml_reader *xml, const xmlNode *node, struct axis *axis)
{
	double tolerance = axis->rotary ? radians(LIMIT_TOLERANCE) : LIMIT_TOLERANCE;
	double rate = xml_number(xml, node, "rate_max", 1) * (axis->rotary ? 1 : xml->unit);

	axis->limit_min = read_position(xml, node, "limit_min", axis->rotary, -INFINITY);
	axis->limit_max = read_position(xml, node, "limit_max", axis->rotary, INFINITY);
	axis->home = read_position(xml, node, "home", axis->rotary, 0);
	axis->rate_max = (axis->rotary ? radians(rate) : rate) / SECONDS_PER_MINUTE;
	if (!(rate >= RATE_MIN && rate <= RATE_MAX))
		xml_error(xml, node, "rate_max=\"%s\" of axis %s is not between 1e-6 and 1e9 %s a minute",
			  xml_quote(xml_attribute(node, "rate_max")).text, axis->name, axis->rotary ? "degrees" : "mm");
	if (!(axis->limit_min < axis->limit_max)) {
		xml_error(xml, node, "limit_min=\"%s\" of axis %s is not less than limit_max=\"%s\"",
			  xml_quote(xml_attribute(node, "limit_min")).text, axis->name,
			  xml_quote(xml_attribute(node, "limit_max")).text);
		return;
	}
	if (axis->home >= axis->limit_min - tolerance && axis->home <= axis->limit_max + tolerance)
		return;
	if (xml_attribute(node, "home"))
		xml_error(xml, node, "home=\"%s\" of axis %s lies outside its limits",
			  xml_quote(xml_attribute(node, "home")).text, axis->name);
	else
		xml_error(xml, node, "0, the default home, lies outside the limits of axis %s: give it a home",
			  axis->name);
}

static void read_axis(struct xml_reader *xml, const xmlNode *node, struct machine *machine, int parent,
		      struct axis *axis)
{
	static const char *const types[] = {"linear", "rotary", NULL};
	static const char *const wraps[] = {"none", "shortest", "sign", NULL};
	static const char *const ways[] = {"positive", "negative", NULL};

	axis->name = arena_strdup(&machine->arena, xml_attribute(node, "name"));
	axis->title = xml_label(xml, node, "title", &machine->arena);
	axis->slot = slot_of_letter(axis->name[0]);
	axis->rotary = slot_is_rotary(axis->slot);
	axis->parent = parent;
	axis->line = xmlGetLineNo(node);
	axis->wrap = (enum wrap)xml_choice(node, "wrap", wraps);
	if (xml_attribute(node, "half_turn"))
		axis->half_turn = xml_choice(node, "half_turn", ways) ? -1 : 1;
	axis->direction = xml_direction(xml, node, "direction");
	axis->location = xml_point(xml, node, "location");
	if (xml_choice(node, "type", types) != axis->rotary)
		xml_error(xml, node, "axis %s cannot be %s: A B C are rotary, X Y Z U V W are linear", axis->name,
			  axis->rotary ? "linear" : "rotary");
	if (axis->rotary && !xml_attribute(node, "location"))
		xml_error(xml, node, "axis %s is rotary and lacks the attribute 'location', a point on its axis",
			  axis->name);
	if (!axis->rotary && axis->wrap != WRAP_NONE)
		xml_error(xml, node, "axis %s is linear: only a rotary axis can have wrap", axis->name);
	if (!axis->rotary && axis->half_turn)
		xml_error(xml, node, "axis %s is linear: only a rotary axis can have half_turn", axis->name);
	read_travel(xml, node, axis);
}

static void read_spindle(struct xml_reader *xml, const xmlNode *node, struct machine *machine, int link)
{
	struct spindle *spindle = &machine->spindle;

	if (spindle->present)
		xml_error(xml, node, "the machine has a second <spindle>");
	*spindle = (struct spindle){.present = true,
				    .link = link,
				    .location = xml_point(xml, node, "location"),
				    .direction = xml_direction(xml, node, "direction")};
}

static void read_workholding(struct xml_reader *xml, const xmlNode *node, struct machine *machine, int link)
{
	struct workholding *workholding = &machine->workholding;

	if (workholding->present)
		xml_error(xml, node, "the machine has a second <workholding>");
	*workholding = (struct workholding){.present = true, .link = link, .frame = xml_frame(xml, node)};
}

static void read_body(struct xml_reader *xml, const xmlNode *node, struct machine *machine, int link)
{
	xform mount = xform_identity();
	struct body body = {.role = ROLE_MACHINE,
			    .link = link,
			    .loc = {.file = machine->path, .line = xmlGetLineNo(node)}};

	if (!body_read(xml, node, &machine->arena, &mount, &body))
		return;
	body_check_name(xml, node, body.name, machine->bodies, machine->body_count);
	machine->bodies[machine->body_count++] = body;
}

/* The content of <base> or of an <axis>; as deep as the schema's limit allows. */
static void read_link(struct xml_reader *xml, const xmlNode *parent, struct machine *machine, int link)
{
	for (const xmlNode *node = xml_first(parent); node; node = xml_next(node)) {
		if (xml_is(node, "body")) {
			read_body(xml, node, machine, link);
		} else if (xml_is(node, "spindle")) {
			read_spindle(xml, node, machine, link);
		} else if (xml_is(node, "workholding")) {
			read_workholding(xml, node, machine, link);
		} else if (machine_axis(machine, slot_of_letter(xml_attribute(node, "name")[0]))) {
			xml_error(xml, node, "the machine has a second axis %s", xml_attribute(node, "name"));
		} else {
			read_axis(xml, node, machine, link, &machine->axes[machine->axis_count]);
			machine->axis_count++;
			read_link(xml, node, machine, (int)machine->axis_count);
		}
	}
}

static void read_base(struct xml_reader *xml, const xmlNode *node, struct machine *machine)
{
	size_t bodies = xml_count(node, "body");

	if (bodies > BODIES_MAX) {
		xml_error(xml, node, "there are %zu bodies; more than %d are not supported", bodies, BODIES_MAX);
		return;
	}
	machine->bodies = arena_alloc(&machine->arena, bodies * sizeof(*machine->bodies));
	read_link(xml, node, machine, 0);
}

static void read_pair_name(struct xml_reader *xml, const xmlNode *node, const char *attribute,
			   struct machine *machine, struct pair_name *out)
{
	static const char *const roles[] = {"", "fixture", "part", "holder", "shank", "cutter", NULL};
	const char *name = xml_name(xml, node, attribute, &machine->arena);
	const struct axis *axis;
	int role;

	if (!name)
		return;
	if (!body_name_is_reserved(name)) {
		*out = (struct pair_name){.kind = NAME_BODY, .body = name};
		return;
	}
	/* In the order of enum body_role. */
	role = xml_choice(node, attribute, roles);
	if (role > 0) {
		*out = (struct pair_name){.kind = NAME_ROLE, .role = (enum body_role)role};
		return;
	}
	*out = (struct pair_name){.kind = NAME_LINK, .link = 0};
	if (strcmp(name, "base") == 0)
		return;
	axis = machine_axis(machine, slot_of_letter(name[0]));
	if (axis)
		out->link = (int)(axis - machine->axes) + 1;
	else
		xml_error(xml, node, "%s=\"%s\" of <pair>: the machine has no axis %s", attribute, name, name);
}

static void read_pair(struct xml_reader *xml, const xmlNode *node, struct machine *machine, struct pair_rule *rule)
{
	static const char *const checks[] = {"", "always", "never", NULL};
	bool clearance = xml_attribute(node, "clearance") != NULL;

	rule->line = xmlGetLineNo(node);
	rule->check = (enum rule_check)xml_choice(node, "check", checks);
	rule->clearance = xml_length(xml, node, "clearance", -1);
	rule->reason = xml_label(xml, node, "reason", &machine->arena);
	read_pair_name(xml, node, "a", machine, &rule->a);
	read_pair_name(xml, node, "b", machine, &rule->b);
	if (strcmp(xml_attribute(node, "a"), xml_attribute(node, "b")) == 0)
		xml_error(xml, node, "<pair> names '%s' twice", xml_quote(xml_attribute(node, "a")).text);
	if (clearance && rule->clearance < 0)
		xml_error(xml, node, "clearance=\"%s\" of <pair> is negative",
			  xml_quote(xml_attribute(node, "clearance")).text);
	if (rule->check == PAIR_NEVER && clearance)
		xml_error(xml, node, "<pair>: what is never checked has no clearance");
	if (rule->check == PAIR_NEVER && (!rule->reason || !*rule->reason))
		xml_error(xml, node, "<pair> with check=\"never\" needs a reason=\"...\"");
	if (rule->check == PAIR_DERIVED && !clearance)
		xml_error(xml, node, "<pair> says nothing: give it a check or a clearance");
}

static void read_pairs(struct xml_reader *xml, const xmlNode *node, struct machine *machine)
{
	size_t count = xml_count(node, "pair");

	if (count > BODIES_MAX) {
		xml_error(xml, node, "there are %zu pairs; more than %d are not supported", count, BODIES_MAX);
		return;
	}
	machine->rules = arena_alloc(&machine->arena, count * sizeof(*machine->rules));
	machine->adjacent_within = xml_length(xml, node, "adjacent_within", ADJACENT_WITHIN);
	if (machine->adjacent_within < 0)
		xml_error(xml, node, "adjacent_within=\"%s\" of <pairs> is negative",
			  xml_quote(xml_attribute(node, "adjacent_within")).text);
	for (const xmlNode *child = xml_first(node); child; child = xml_next(child))
		read_pair(xml, child, machine, &machine->rules[machine->rule_count++]);
}

static const xmlNode *child_of(const xmlNode *parent, const char *name)
{
	const xmlNode *node = xml_first(parent);

	while (node && !xml_is(node, name))
		node = xml_next(node);
	return node;
}

/* Pairs and places name axes, and setups stand on the spindle and the table: so in this order, whatever the file's. */
static void read_machine(struct xml_reader *xml, struct machine *machine)
{
	const xmlNode *root = xml_root(xml);
	const xmlNode *controller = child_of(root, "controller");
	const xmlNode *pairs = child_of(root, "pairs");
	const xmlNode *setup = child_of(root, "setup");
	const char *name = xml_label(xml, root, "name", &machine->arena);

	machine->name = name ? name : "";
	machine->controller.unit = xml->unit;
	machine->adjacent_within = ADJACENT_WITHIN;
	if (controller)
		read_controller(xml, controller, machine);
	read_base(xml, child_of(root, "base"), machine);
	if (controller)
		places_read(xml, controller, machine);
	if (pairs)
		read_pairs(xml, pairs, machine);
	if (setup)
		machine->setup = setup_read(xml, setup, machine);
}

struct machine *machine_load(const char *path, struct diag *diag)
{
	struct xml_reader xml;
	struct machine *machine;

	if (!xml_open(&xml, path, "machine", diag))
		return NULL;
	machine = mem_zalloc(1, sizeof(*machine));
	machine->path = arena_strdup(&machine->arena, path);
	read_machine(&xml, machine);
	xml_close(&xml);
	if (!xml.errors)
		return machine;
	machine_free(machine);
	return NULL;
}
