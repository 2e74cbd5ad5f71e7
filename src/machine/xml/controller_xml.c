#include "machine/xml/controller_xml.h"

#include "base/ascii.h"
#include "control/dialects.h"
#include "machine/description.h"
#include "machine/xml/variable_xml.h"
#include "machine/xml/xml_attribute.h"
#include "machine/xml/xml_element.h"

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

/* May the name of a program begin with this byte? */
static bool may_begin_name(char byte)
{
	return ascii_is_letter(byte) || byte == '_';
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
	if (program && may_begin_name(program[0]))
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
	struct machine_description *described = context;
	struct controller_description *controller = &described->controller;

	variable_xml_read(xml, node, &described->arena, &controller->variables[controller->variable_count++]);
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

/* The position of the attribute's word among those that follow, from 1; 0: it is not given. */
#define ANSWER(attribute, ...) (xml_choice(xml, node, attribute, (const char *const[]){__VA_ARGS__, NULL}, -1) + 1)

/* The first rotary slot, or the second or third, by the position of its word; 0: it is not given. */
static int rotary_slot(int answer)
{
	return answer ? SLOT_A + answer - 1 : 0;
}

/* The modes at the start of each program. */
static void read_power_on(struct xml_reader *xml, const xmlNode *node, struct controller *told)
{
	told->power_on_units = ANSWER("power_on_units", "mm", "inch");
	told->power_on_distance = ANSWER("power_on_distance", "absolute", "incremental");
	told->power_on_plane = ANSWER("power_on_plane", "xy", "zx", "yz");
	told->power_on_motion = ANSWER("power_on_motion", "rapid", "feed");
	told->power_on_work_offset = ANSWER("power_on_work_offset", "G500", "G54", "G55", "G56", "G57");
}

/* The settings of a control that has parameters for them. */
static void read_parameters(struct xml_reader *xml, const xmlNode *node, struct controller *told)
{
	told->length_moves = ANSWER("length_offset_moves", "yes", "no");
	told->length_after_reference = ANSWER("length_after_reference", "keeps", "cancels");
	told->cycle_axis = ANSWER("cycle_axis", "plane", "z");
	told->cycle_repeats = ANSWER("cycle_repeats", "K", "L");
	told->g53_with_g91 = ANSWER("g53_with_g91", "absolute", "incremental");
	told->m6_with_move = ANSWER("m6_with_move", "after", "before");
	told->m6_with_t = ANSWER("m6_with_t", "own", "before", "first");
	told->length_under_g68 = ANSWER("length_under_g68", "turned", "straight");
	told->polar_axis = rotary_slot(ANSWER("polar_axes", "XA", "XB", "XC"));
	told->semicolon = ANSWER("semicolon", "comment", "block-end");
	told->colon = ANSWER("colon", "program", "block");
	told->comp_d = ANSWER("cutter_comp_d", "radius", "diameter");
	told->comp_start = ANSWER("cutter_comp_start", "A", "B");
	told->comp_corner = ANSWER("cutter_comp_corner", "linear", "circular");
}

/* The settings of a control whose programs have frames, tool edges, and planes that a cycle swivels. */
static void read_frames(struct xml_reader *xml, const xmlNode *node, struct controller *told)
{
	/* The position of each word is its number. */
	told->comp_idle_blocks = ANSWER("cutter_comp_idle_blocks", "1", "2", "3", "4", "5", "6", "7", "8", "9");
	told->rotation_order = ANSWER("rotation_order", "rpy", "euler");
	told->cycle_19_angles = ANSWER("cycle_19_angles", "spatial", "axes");
	told->cycle_11_axes = ANSWER("cycle_11_axes", "plane", "all");
	told->orientation_interpolation = ANSWER("orientation_interpolation", "axes", "vector", "oriwks");
	told->edge_after_tool_change = ANSWER("edge_after_tool_change", "first", "none", "keeps");
	told->t_changes_tool = ANSWER("t_changes_tool", "yes", "no");
	told->mirror_toggle = ANSWER("mirror_toggle", "yes", "no");
	told->frames_outlive_traori = ANSWER("frames_outlive_traori", "yes", "no");
	told->frames_outlive_cycle800 = ANSWER("frames_outlive_cycle800", "yes", "no");
	told->length_along_z = ANSWER("tool_length_axis", "z");
	told->increments_after_shift = ANSWER("increments_after_shift", "traverse", "stay");
	told->swivel_axis = rotary_slot(ANSWER("swivel_axis", "A", "B", "C"));
	told->orientation_pole = ANSWER("orientation_pole", "axes");
	told->swivel_pole = ANSWER("swivel_pole", "zero", "stays");
	told->tool_def = ANSWER("tool_def", "ignored");
	told->rotary_way = ANSWER("rotary_way", "plain", "shorter");
	told->rotary_angle = ANSWER("rotary_angle", "as-written", "reduced");
	told->m6 = ANSWER("m6", "ignored");
	told->plane_rotation = ANSWER("plane_rotation", "coordinates", "table");
	told->plane_retract = ANSWER("plane_retract", "always", "turning");
	told->shift_behind_plane = ANSWER("shift_behind_plane", "keeps", "cancelled");
}

/* Allocates memory for all tables of the element. */
static void make_room(const xmlNode *node, struct arena *arena, struct controller_description *controller)
{
	const size_t places =
	    xml_count(node, "reference") + xml_count(node, "tool_change") + xml_count(node, "swivel_retract");

	controller->mcodes = arena_alloc(arena, xml_count(node, "mcode") * sizeof(*controller->mcodes));
	controller->macros = arena_alloc(arena, xml_count(node, "macro") * sizeof(*controller->macros));
	controller->variables = arena_alloc(arena, xml_count(node, "variable") * sizeof(*controller->variables));
	controller->places = arena_alloc(arena, places * sizeof(*controller->places));
}

void controller_xml_read(struct xml_reader *xml, const xmlNode *node, void *context)
{
	static const char *const rapids[] = {
		[RAPID_LINEAR] = "linear", [RAPID_DOGLEG] = "dogleg", [RAPID_ANY] = "any", NULL,
	};
	static const struct xml_child children[] = {{"mcode", read_mcode, false, false},
						    {"macro", read_macro, false, false},
						    {"variable", read_variable, false, false},
						    {"reference", read_reference, false, false},
						    {"tool_change", read_tool_change, false, false},
						    {"swivel_retract", read_swivel_retract, false, false},
						    {.name = NULL}};
	struct machine_description *described = context;
	struct controller_description *controller = &described->controller;
	struct controller *told = &controller->told;
	const int tcp_zero = ANSWER("tcp_zero", "machine", "offset");

	controller->at = node;
	controller->preset = xml_label(xml, node, "preset", &described->arena);
	controller->path_tolerance = xml_optional_length(xml, node, "path_tolerance");
	controller->least_input = xml_optional_number(xml, node, "least_input");
	controller->overrun = xml_optional_length(xml, node, "unidirectional_overrun");
	controller->arc_radius_tolerance = xml_optional_length(xml, node, "arc_radius_tolerance");
	told->dialect = xml_choice(xml, node, "dialect", dialect_names, 0);
	told->rapid = (enum rapid)xml_choice(xml, node, "rapid", rapids, RAPID_LINEAR);
	told->rapid_given = ANSWER("rapid", "linear", "dogleg", "any") ? ANSWER_YES : ANSWER_UNKNOWN;
	told->tcp_zero_given = tcp_zero ? ANSWER_YES : ANSWER_UNKNOWN;
	told->tcp_zero_offset = tcp_zero == 2;
	read_power_on(xml, node, told);
	read_parameters(xml, node, told);
	read_frames(xml, node, told);
	make_room(node, &described->arena, controller);
	xml_read_children(xml, node, children, described);
}
