#include "machine/machine.h"

#include <math.h>

#include "machine/controller_build.h"
#include "machine/machine_build.h"
#include "machine/xml/body_xml.h"
#include "machine/xml/controller_xml.h"
#include "machine/xml/setup_xml.h"
#include "machine/xml/xml_attribute.h"
#include "machine/xml/xml_element.h"

static const char *const elements[] = {
	"machine", "controller", CONTROLLER_XML_ELEMENTS, "base", "body", "axis", "spindle", "workholding", "pairs",
	"pair", SETUP_XML_ELEMENTS, NULL,
};

/* ------------------------------------------------------------------- links */

/* Everything that is mounted on one link. */
struct link_context {
	struct machine_description *described;
	int link;
};

static void read_body(struct xml_reader *xml, const xmlNode *node, void *context)
{
	const struct link_context *on = context;
	struct body_description *body = &on->described->bodies[on->described->body_count++];

	body->role = ROLE_MACHINE;
	body->link = on->link;
	body_xml_read(xml, node, &on->described->arena, body);
}

static void read_spindle(struct xml_reader *xml, const xmlNode *node, void *context)
{
	const struct link_context *on = context;
	struct spindle_description *spindle = &on->described->spindles[on->described->spindle_count++];

	xml_require(xml, node, "location", "direction", NULL);
	*spindle = (struct spindle_description){
		.at = node,
		.link = on->link,
		.location = xml_point(xml, node, "location"),
		.direction = xml_vector(xml, node, "direction"),
		.checked = xml_name(xml, node, "checked", &on->described->arena),
	};
	xml_read_nothing(xml, node);
}

static void read_workholding(struct xml_reader *xml, const xmlNode *node, void *context)
{
	const struct link_context *on = context;

	on->described->workholdings[on->described->workholding_count++] =
		(struct workholding_description){.at = node, .link = on->link, .frame = xml_frame(xml, node),
						 .checked = xml_name(xml, node, "checked", &on->described->arena)};
	xml_read_nothing(xml, node);
}

static void read_axis(struct xml_reader *xml, const xmlNode *node, void *context);

static const struct xml_child link_children[] = {{"body", read_body, false, false},
						 {"axis", read_axis, false, false},
						 {"spindle", read_spindle, false, false},
						 {"workholding", read_workholding, false, false},
						 {.name = NULL}};

/* Positions in the unit of the axis: mm or radians. */
static double read_limit(struct xml_reader *xml, const xmlNode *node, const char *name, bool rotary, double fallback)
{
	return rotary ? xml_angle(xml, node, name, fallback) : xml_length(xml, node, name, fallback);
}

static void read_axis(struct xml_reader *xml, const xmlNode *node, void *context)
{
	static const char *const letters[] = {"X", "Y", "Z", "A", "B", "C", "U", "V", "W", NULL};
	static const char *const types[] = {"linear", "rotary", NULL};
	static const char *const wraps[] = {
		[WRAP_NONE] = "none", [WRAP_SHORTEST] = "shortest", [WRAP_SIGN] = "sign", NULL,
	};
	static const char *const ways[] = {"positive", "negative", NULL};
	static const int signs[] = {0, 1, -1};
	const struct link_context *on = context;
	struct machine_description *described = on->described;
	struct axis_description *axis = &described->axes[described->axis_count++];
	struct link_context here = {described, (int)described->axis_count};
	bool rotary;

	xml_require(xml, node, "name", "type", "direction", "rate_max", NULL);
	axis->at = node;
	axis->slot = xml_choice(xml, node, "name", letters, SLOT_X);
	rotary = slot_is_rotary(axis->slot);
	axis->parent = on->link;
	axis->checked = xml_name(xml, node, "checked", &described->arena);
	axis->title = xml_label(xml, node, "title", &described->arena);
	axis->rotary = xml_choice(xml, node, "type", types, 0) == 1;
	axis->wrap = (enum wrap)xml_choice(xml, node, "wrap", wraps, WRAP_NONE);
	axis->half_turn = signs[xml_choice(xml, node, "half_turn", ways, -1) + 1];
	axis->direction = xml_vector(xml, node, "direction");
	axis->has_location = xml_attribute(xml, node, "location") != NULL;
	axis->location = xml_point(xml, node, "location");
	axis->limit_min = read_limit(xml, node, "limit_min", rotary, -INFINITY);
	axis->limit_max = read_limit(xml, node, "limit_max", rotary, INFINITY);
	axis->home = rotary ? xml_optional_angle(xml, node, "home") : xml_optional_length(xml, node, "home");
	axis->rate_max = xml_number(xml, node, "rate_max", 1) * (rotary ? 1 : xml->unit);
	xml_read_children(xml, node, link_children, &here);
}

static void read_base(struct xml_reader *xml, const xmlNode *node, void *context)
{
	struct machine_description *described = context;
	struct link_context base = {described, 0};

	described->base = node;
	described->base_checked = xml_name(xml, node, "checked", &described->arena);
	xml_read_children(xml, node, link_children, &base);
}

/* ------------------------------------------------------------------- pairs */

static void read_pair(struct xml_reader *xml, const xmlNode *node, void *context)
{
	static const char *const checks[] = {"always", "never", NULL};
	static const enum rule_check meanings[] = {PAIR_DERIVED, PAIR_ALWAYS, PAIR_NEVER};
	struct machine_description *described = context;
	struct pair_description *pair = &described->pairs[described->pair_count++];

	xml_require(xml, node, "a", "b", NULL);
	pair->at = node;
	pair->a = xml_name(xml, node, "a", &described->arena);
	pair->b = xml_name(xml, node, "b", &described->arena);
	pair->check = meanings[xml_choice(xml, node, "check", checks, -1) + 1];
	pair->clearance = xml_optional_length(xml, node, "clearance");
	pair->reason = xml_label(xml, node, "reason", &described->arena);
	xml_read_nothing(xml, node);
}

static void read_pairs(struct xml_reader *xml, const xmlNode *node, void *context)
{
	static const struct xml_child children[] = {{"pair", read_pair, false, false}, {.name = NULL}};
	struct machine_description *described = context;

	described->pairs_at = node;
	described->adjacent_within = xml_optional_length(xml, node, "adjacent_within");
	xml_read_children(xml, node, children, described);
}

/* ----------------------------------------------------------------- machine */

static void read_setup(struct xml_reader *xml, const xmlNode *node, void *context)
{
	struct machine_description *described = context;

	described->setup = arena_alloc(&described->arena, sizeof(*described->setup));
	setup_xml_read(xml, node, described->setup);
}

static void read_machine(struct xml_reader *xml, struct machine_description *described)
{
	static const struct xml_child children[] = {{"controller", controller_xml_read, true, false},
						    {"base", read_base, true, true},
						    {"pairs", read_pairs, true, false},
						    {"setup", read_setup, true, false},
						    {.name = NULL}};
	const xmlNode *root = xml_root(xml);
	struct arena *arena = &described->arena;

	described->file = xml_description_file(xml);
	xml_require(xml, root, "version", NULL);
	described->name = xml_label(xml, root, "name", arena);
	described->unit = xml->unit = xml_file_units(xml, root, 1);
	described->axes = arena_alloc(arena, xml_count(root, "axis") * sizeof(*described->axes));
	described->bodies = arena_alloc(arena, xml_count(root, "body") * sizeof(*described->bodies));
	described->spindles = arena_alloc(arena, xml_count(root, "spindle") * sizeof(*described->spindles));
	described->workholdings =
	    arena_alloc(arena, xml_count(root, "workholding") * sizeof(*described->workholdings));
	described->pairs = arena_alloc(arena, xml_count(root, "pair") * sizeof(*described->pairs));
	xml_read_children(xml, root, children, described);
}

static void drop(struct machine_description *described)
{
	if (described->setup)
		arena_release(&described->setup->arena);
	arena_release(&described->arena);
}

struct machine *machine_load(const char *path, struct diag *diag)
{
	return machine_load_within(path, NULL, diag);
}

struct machine *machine_load_within(const char *path, const char *root, struct diag *diag)
{
	struct machine_description described = {.unit = 1};
	struct machine *machine = NULL;
	struct xml_reader xml;

	if (!xml_open(&xml, path, elements, diag))
		return NULL;
	xml.root = root;
	read_machine(&xml, &described);
	if (!xml.errors) {
		machine = machine_build(&described, diag);
	} else {
		drop(&described);
	}
	xml_close(&xml);
	return machine;
}

bool machine_check_controller(const char *text, struct diag *diag)
{
	struct machine_description described = {.unit = 1};
	struct machine machine = {.path = NULL};
	struct xml_reader xml;
	bool good;

	if (!xml_open_text(&xml, text, elements, diag))
		return false;
	read_machine(&xml, &described);
	if (!xml.errors)
		controller_build(&described, &machine);
	good = !xml.errors && !described.file.faults;
	arena_release(&machine.arena);
	drop(&described);
	xml_close(&xml);
	return good;
}
