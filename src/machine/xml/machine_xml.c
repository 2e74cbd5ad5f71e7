#include "machine/machine.h"

#include <math.h>

#include "control/dialects.h"
#include "machine/machine_build.h"
#include "machine/xml/body_xml.h"
#include "machine/xml/setup_xml.h"
#include "machine/xml/xml_attribute.h"
#include "machine/xml/xml_element.h"

static const char *const elements[] = {
	"machine", "controller", "mcode",	"macro",	"reference", "tool_change", "swivel_retract", "base",
	"body",	   "axis",	 "spindle",	"workholding", "pairs",	    "pair", SETUP_XML_ELEMENTS, NULL,
};

/* -------------------------------------------------------------- controller */

static void read_mcode(struct xml_reader *xml, const xmlNode *node, void *context)
{
	static const char *const actions[] = {
		[MCODE_TCP_ON] = "tcp-on", [MCODE_TCP_OFF] = "tcp-off", [MCODE_IGNORE] = "ignore",
		[MCODE_SPINDLE_ON] = "spindle-on", [MCODE_SPINDLE_OFF] = "spindle-off", NULL,
	};
	struct machine_description *described = context;
	struct mcode_description *mcode = &described->controller.mcodes[described->controller.mcode_count++];

	xml_require(xml, node, "number", "action", NULL);
	mcode->at = node;
	mcode->number = xml_whole(xml, node, "number", 0);
	mcode->action = (enum mcode_action)xml_choice(xml, node, "action", actions, MCODE_IGNORE);
	xml_read_nothing(xml, node);
}

/* What the name of a program begins with. */
static bool is_letter(char byte)
{
	return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || byte == '_';
}

static void read_macro(struct xml_reader *xml, const xmlNode *node, void *context)
{
	static const char *const actions[] = {
		[MACRO_NONE] = "none", [MACRO_MOVE] = "move", [MACRO_AROUND] = "around", NULL,
	};
	struct machine_description *described = context;
	struct macro_description *macro = &described->controller.macros[described->controller.macro_count++];
	const char *program = xml_attribute(xml, node, "program");

	xml_require(xml, node, "action", NULL);
	macro->at = node;
	macro->has_program = program != NULL;
	if (program && is_letter(program[0]))
		macro->name = arena_strdup(&described->arena, program);
	else
		macro->program = xml_whole(xml, node, "program", 0);
	macro->code = xml_optional_number(xml, node, "code");
	macro->action = (enum macro_action)xml_choice(xml, node, "action", actions, MACRO_NONE);
	xml_axis_values(xml, node, macro->around);
	xml_read_nothing(xml, node);
}

static void read_variable(struct xml_reader *xml, const xmlNode *node, void *context)
{
	static const char *const types[] = {
		[CONTROL_REAL] = "REAL", [CONTROL_INT] = "INT",	      [CONTROL_BOOL] = "BOOL", [CONTROL_CHAR] = "CHAR",
		[CONTROL_STRING] = "STRING", [CONTROL_AXIS] = "AXIS", NULL,
	};
	struct machine_description *described = context;
	struct controller_description *controller = &described->controller;

	xml_require(xml, node, "name", NULL);
	controller->variables[controller->variable_count++] = (struct variable_description){
		.at = node,
		.name = xml_name(xml, node, "name", &described->arena),
		.value = xml_label(xml, node, "value", &described->arena),
		.size = xml_label(xml, node, "size", &described->arena),
		.type = xml_choice(xml, node, "type", types, -1),
	};
	xml_read_nothing(xml, node);
}

static struct place_description *read_place(struct xml_reader *xml, const xmlNode *node,
					    struct machine_description *described)
{
	struct place_description *place = &described->controller.places[described->controller.place_count++];
	const char *order = xml_attribute(xml, node, "order");

	place->at = node;
	place->order = order ? arena_strdup(&described->arena, order) : NULL;
	xml_axis_values(xml, node, place->value);
	return place;
}

static void read_reference(struct xml_reader *xml, const xmlNode *node, void *context)
{
	struct place_description *place = read_place(xml, node, context);

	xml_require(xml, node, "number", NULL);
	place->number = xml_whole(xml, node, "number", 0);
	xml_read_nothing(xml, node);
}

static void read_tool_change(struct xml_reader *xml, const xmlNode *node, void *context)
{
	read_place(xml, node, context)->tool_change = true;
	xml_read_nothing(xml, node);
}

static void read_swivel_retract(struct xml_reader *xml, const xmlNode *node, void *context)
{
	read_place(xml, node, context)->swivel_retract = true;
	xml_read_nothing(xml, node);
}

/* The answers of a control whose programs have frames, edges of tools and planes that a cycle swivels. */
static void read_frames(struct xml_reader *xml, const xmlNode *node, struct controller_description *controller)
{
	static const char *const orders[] = {"rpy", "euler", NULL};
	static const char *const ways[] = {"axes", "vector", NULL};
	static const char *const edges[] = {"first", "none", "keeps", NULL};
	static const char *const answers[] = {"yes", "no", NULL};
	static const char *const length_axes[] = {"z", NULL};
	static const char *const rotary[] = {"A", "B", "C", NULL};
	static const char *const increments[] = {"traverse", "stay", NULL};
	static const char *const systems[] = {"G500", "G54", "G55", "G56", "G57", NULL};
	static const char *const angles[] = {"spatial", "axes", NULL};
	static const char *const scaled[] = {"plane", "all", NULL};
	static const char *const poles[] = {"zero", "stays", NULL};
	static const char *const definitions[] = {"ignored", NULL};
	static const char *const retracts[] = {"always", "turning", NULL};
	static const char *const pole_ways[] = {"axes", NULL};
	const int swivel = xml_choice(xml, node, "swivel_axis", rotary, -1);

	controller->rotation_order = (enum rotation_order)(xml_choice(xml, node, "rotation_order", orders, -1) + 1);
	controller->cycle_19_angles = (enum cycle_19_angles)(xml_choice(xml, node, "cycle_19_angles", angles, -1) + 1);
	controller->cycle_11_axes = (enum cycle_11_axes)(xml_choice(xml, node, "cycle_11_axes", scaled, -1) + 1);
	controller->orientation_interpolation =
	    (enum orientation_interpolation)(xml_choice(xml, node, "orientation_interpolation", ways, -1) + 1);
	controller->edge_after_tool_change =
	    (enum edge_after_tool_change)(xml_choice(xml, node, "edge_after_tool_change", edges, -1) + 1);
	controller->frames_outlive_traori =
	    (enum answer)(xml_choice(xml, node, "frames_outlive_traori", answers, -1) + 1);
	controller->length_along_z = (enum answer)(xml_choice(xml, node, "tool_length_axis", length_axes, -1) + 1);
	controller->increments_after_shift =
	    (enum increments_after_shift)(xml_choice(xml, node, "increments_after_shift", increments, -1) + 1);
	controller->power_on_work_offset = xml_choice(xml, node, "power_on_work_offset", systems, -1) + 1;
	controller->swivel_axis = swivel < 0 ? 0 : SLOT_A + swivel;
	controller->orientation_pole =
	    (enum orientation_pole)(xml_choice(xml, node, "orientation_pole", pole_ways, -1) + 1);
	controller->swivel_pole = (enum swivel_pole)(xml_choice(xml, node, "swivel_pole", poles, -1) + 1);
	controller->tool_def = (enum tool_def)(xml_choice(xml, node, "tool_def", definitions, -1) + 1);
	controller->plane_retract = (enum plane_retract)(xml_choice(xml, node, "plane_retract", retracts, -1) + 1);
}

static void read_controller(struct xml_reader *xml, const xmlNode *node, void *context)
{
	static const char *const rapids[] = {
		[RAPID_LINEAR] = "linear", [RAPID_DOGLEG] = "dogleg", [RAPID_ANY] = "any", NULL,
	};
	static const char *const zeros[] = {"machine", "offset", NULL};
	static const char *const answers[] = {"yes", "no", NULL};
	static const char *const length_ways[] = {"turned", "straight", NULL};
	static const char *const polar_axes[] = {"XA", "XB", "XC", NULL};
	static const enum answer meanings[] = {ANSWER_UNKNOWN, ANSWER_YES, ANSWER_NO};
	static const char *const lengths[] = {
		[LENGTH_AFTER_REFERENCE_KEPT - 1] = "keeps", [LENGTH_AFTER_REFERENCE_GONE - 1] = "cancels", NULL,
	};
	static const char *const units[] = {"mm", "inch", NULL};
	static const char *const distances[] = {"absolute", "incremental", NULL};
	static const char *const planes[] = {"xy", "zx", "yz", NULL};
	static const char *const tools[] = {"own", "before", NULL};
	static const char *const orders[] = {"after", "before", NULL};
	static const char *const motions[] = {"rapid", "feed", NULL};
	static const char *const repeats[] = {"K", "L", NULL};
	static const char *const semicolons[] = {"comment", "block-end", NULL};
	static const char *const colons[] = {"program", "block", NULL};
	static const char *const registers[] = {"radius", "diameter", NULL};
	static const char *const starts[] = {"A", "B", NULL};
	static const char *const corners[] = {"linear", "circular", NULL};
	static const struct xml_child children[] = {{"mcode", read_mcode, false, false},
						    {"macro", read_macro, false, false},
						    {"variable", read_variable, false, false},
						    {"reference", read_reference, false, false},
						    {"tool_change", read_tool_change, false, false},
						    {"swivel_retract", read_swivel_retract, false, false},
						    {.name = NULL}};
	const char *preset;
	int polar;
	struct machine_description *described = context;
	struct controller_description *controller = &described->controller;
	const size_t places =
	    xml_count(node, "reference") + xml_count(node, "tool_change") + xml_count(node, "swivel_retract");

	controller->at = node;
	controller->dialect = xml_choice(xml, node, "dialect", dialect_names, 0);
	controller->rapid = (enum rapid)xml_choice(xml, node, "rapid", rapids, RAPID_LINEAR);
	controller->tcp_zero_given =
	    xml_choice(xml, node, "tcp_zero", zeros, -1) >= 0 ? ANSWER_YES : ANSWER_UNKNOWN;
	controller->tcp_zero_offset = xml_choice(xml, node, "tcp_zero", zeros, 0) == 1;
	controller->path_tolerance = xml_optional_length(xml, node, "path_tolerance");
	controller->least_input = xml_optional_number(xml, node, "least_input");
	controller->length_moves = meanings[xml_choice(xml, node, "length_offset_moves", answers, -1) + 1];
	controller->length_after_reference =
	    (enum length_after_reference)(xml_choice(xml, node, "length_after_reference", lengths, -1) + 1);
	controller->power_on_units = (enum power_on_units)(xml_choice(xml, node, "power_on_units", units, -1) + 1);
	controller->power_on_distance =
	    (enum power_on_distance)(xml_choice(xml, node, "power_on_distance", distances, -1) + 1);
	controller->power_on_plane = (enum power_on_plane)(xml_choice(xml, node, "power_on_plane", planes, -1) + 1);
	controller->power_on_motion = (enum power_on_motion)(xml_choice(xml, node, "power_on_motion", motions, -1) + 1);
	controller->cycle_repeats = (enum cycle_repeats)(xml_choice(xml, node, "cycle_repeats", repeats, -1) + 1);
	controller->g53_with_g91 = (enum g53_with_g91)(xml_choice(xml, node, "g53_with_g91", distances, -1) + 1);
	controller->overrun = xml_optional_length(xml, node, "unidirectional_overrun");
	controller->arc_radius_tolerance = xml_optional_length(xml, node, "arc_radius_tolerance");
	controller->m6_with_move = (enum m6_with_move)(xml_choice(xml, node, "m6_with_move", orders, -1) + 1);
	controller->m6_with_t = (enum m6_with_t)(xml_choice(xml, node, "m6_with_t", tools, -1) + 1);
	controller->length_under_g68 =
	    (enum length_under_g68)(xml_choice(xml, node, "length_under_g68", length_ways, -1) + 1);
	polar = xml_choice(xml, node, "polar_axes", polar_axes, -1);
	controller->polar_axis = polar < 0 ? 0 : SLOT_A + polar;
	controller->semicolon = (enum semicolon)(xml_choice(xml, node, "semicolon", semicolons, -1) + 1);
	controller->colon = (enum colon)(xml_choice(xml, node, "colon", colons, -1) + 1);
	preset = xml_attribute(xml, node, "preset");
	controller->preset = preset ? arena_strdup(&described->arena, preset) : NULL;
	controller->comp_d = (enum comp_d)(xml_choice(xml, node, "cutter_comp_d", registers, -1) + 1);
	controller->comp_start = (enum comp_start)(xml_choice(xml, node, "cutter_comp_start", starts, -1) + 1);
	controller->comp_corner = (enum comp_corner_form)(xml_choice(xml, node, "cutter_comp_corner", corners, -1) + 1);
	read_frames(xml, node, controller);
	controller->mcodes = arena_alloc(&described->arena, xml_count(node, "mcode") * sizeof(*controller->mcodes));
	controller->macros = arena_alloc(&described->arena, xml_count(node, "macro") * sizeof(*controller->macros));
	controller->variables =
	    arena_alloc(&described->arena, xml_count(node, "variable") * sizeof(*controller->variables));
	controller->places = arena_alloc(&described->arena, places * sizeof(*controller->places));
	xml_read_children(xml, node, children, described);
}

/* ------------------------------------------------------------------- links */

/* What hangs on one link. */
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
	static const struct xml_child children[] = {{"controller", read_controller, true, false},
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
		if (described.setup)
			arena_release(&described.setup->arena);
		arena_release(&described.arena);
	}
	xml_close(&xml);
	return machine;
}
