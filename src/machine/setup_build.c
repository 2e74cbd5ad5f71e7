#include "machine/setup_build.h"

#include <math.h>
#include <string.h>

#include "base/mem.h"
#include "geom/tolerance.h"
#include "machine/body_build.h"
#include "machine/offset_name.h"
#include "machine/stock_build.h"
#include "machine/tool_build.h"
#include "machine/variable_build.h"

static void build_work_offset(struct description_file *file, const struct work_offset_description *described,
			      const struct machine *machine, struct setup *setup)
{
	struct work_offset offset = {.checked = described->checked,
				     .line = description_place(file, described->at).line};
	char name[OFFSET_NAME_SIZE];

	if (!offset_name_read(described->name, name)) {
		description_fault(file, described->at, "name",
				  "name=\"%s\" of <work_offset> must be G54 to G59, G59.1, G59.2, G59.3, G54.1 P1 to "
				  "P300 (or G154 P1 to P99, G110 to G129), G54.4 P1 to P7, G505 to G599 or #0 to #9999",
				  description_quote(file, described->at, "name").text);
		return;
	}
	offset.name = arena_strdup(&setup->arena, name);
	for (size_t i = 0; i < setup->offset_count; i++) {
		if (strcmp(setup->offsets[i].name, offset.name) == 0) {
			description_fault(file, described->at, "name",
					  "work offset %s is given twice (also in line %ld)", offset.name,
					  setup->offsets[i].line);
			return;
		}
	}
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		const char letter[] = {AXIS_LETTERS[slot], '\0'};

		if (described->value[slot].given && !machine_axis(machine, slot))
			description_fault(file, described->at, letter,
					  "work offset %s has a value for %s, but the machine has no axis %s",
					  offset.name, letter, letter);
		offset.value.v[slot] = described->value[slot].value;
	}
	setup->offsets[setup->offset_count++] = offset;
}

/* A fixture, a part or the stock. */
static void build_mounted(struct description_file *file, const struct body_description *described,
			  const struct machine *machine, struct setup *setup)
{
	struct body body = {.link = machine->workholding.link};

	if (!body_build(file, described, &machine->workholding.frame, &body))
		return;
	if (body.role == ROLE_PART) {
		body.rapid_allowance = body_build_depth(file, described->at, "part", "rapid_allowance",
							described->rapid_allowance, RAPID_ALLOWANCE);
		body.gouge = body_build_depth(file, described->at, "part", "gouge", described->gouge, -1);
	}
	if (body.role == ROLE_STOCK)
		stock_build(file, described, setup, &body);
	body_check_name(file, described->at, body.name, machine->bodies, machine->body_count);
	body_check_name(file, described->at, body.name, setup->bodies, setup->body_count);
	setup->bodies[setup->body_count++] = body;
}

static bool is_given_before(const struct setup *setup, long number)
{
	for (size_t i = 0; i < setup->length_count; i++) {
		if (setup->lengths[i].number == number)
			return true;
	}
	for (size_t i = 0; i < setup->radius_count; i++) {
		if (setup->radii[i].number == number)
			return true;
	}
	return false;
}

/* A control's D may be a diameter; for a value of 0 this does not matter. False: reported. */
static bool find_radius(struct description_file *file, const struct length_offset_description *described,
			const struct machine *machine, double *radius)
{
	enum comp_d form = machine->controller.comp_d;

	*radius = described->radius.value;
	if (!described->d_of_control || !described->radius.given || !(fabs(*radius) > 0))
		return true;
	if (form == COMP_D_DIAMETER)
		*radius /= 2;
	if (form != COMP_D_UNKNOWN)
		return true;
	description_fault(file, described->at, "href",
			  "D%ld is not 0, and a parameter of the control decides whether D is a radius or a diameter: "
			  "set cutter_comp_d=\"radius\" or \"diameter\" in the machine file's <controller>",
			  described->number);
	return false;
}

static void build_length(struct description_file *file, const struct length_offset_description *described,
			 const struct machine *machine, struct setup *setup)
{
	double radius;


	if (described->number > TOOL_NUMBER_MAX) {
		description_fault(file, described->at, "number", "number=\"%s\" of <offset> is not between 1 and %d",
				  description_quote(file, described->at, "number").text, TOOL_NUMBER_MAX);
		return;
	}
	if (!described->length.given && !described->radius.given) {
		description_fault(file, described->at, NULL, "<offset> needs a length or a radius");
		return;
	}
	if (is_given_before(setup, described->number))
		description_fault(file, described->at, "number", "<offset> %ld is given twice", described->number);
	if (!find_radius(file, described, machine, &radius))
		return;
	if (described->length.given)
		setup->lengths[setup->length_count++] =
			(struct length_offset){.number = (int)described->number, .length = described->length.value};
	if (described->radius.given)
		setup->radii[setup->radius_count++] =
			(struct radius_offset){.number = (int)described->number, .radius = radius};
}

/* The first edge is the tool's own row, unless its number is given, too. */
static void build_edge(struct description_file *file, const struct edge_description *described, struct setup *setup)
{
	struct tool_edge edge = {.tool = (int)described->tool, .number = (int)described->number,
				 .length = described->length,
				 .diameter = described->no_radius ? -1 : described->diameter.value};

	if (described->number < 2 || described->number > TOOL_NUMBER_MAX) {
		description_fault(file, described->at, "number",
				  "number=\"%s\" of <edge> is not between 2 and %d; edge 1 is the tool itself",
				  description_quote(file, described->at, "number").text, TOOL_NUMBER_MAX);
		return;
	}
	if (described->diameter.given && !(edge.diameter > 0))
		description_fault(file, described->at, "diameter", "diameter=\"%s\" of <edge> must be greater than 0",
				  description_quote(file, described->at, "diameter").text);
	for (size_t i = 0; i < setup->edge_count; i++) {
		if (setup->edges[i].tool == edge.tool && setup->edges[i].number == edge.number)
			description_fault(file, described->at, "number", "<edge> %d of tool %d is given twice",
					  edge.number, edge.tool);
	}
	setup->edges[setup->edge_count++] = edge;
}

/* Gives every tool the H of its number, unless an <offset> defines that H. */
static void add_tool_lengths(struct setup *setup)
{
	size_t given = setup->length_count;

	for (size_t i = 0; i < setup->tool_count; i++) {
		const struct tool *tool = &setup->tools[i];
		size_t k = 0;

		while (k < given && setup->lengths[k].number != tool->number)
			k++;
		if (k == given)
			setup->lengths[setup->length_count++] =
				(struct length_offset){.number = tool->number, .length = tool->length_offset};
	}
}

/* Allocates memory for everything; false, reported: there is too much. */
static bool make_room(struct setup_description *described, struct setup *setup)
{
	const size_t mounted = described->body_count, tools = described->tool_count, lengths = described->length_count;

	if (mounted > BODIES_MAX || tools > BODIES_MAX || lengths > BODIES_MAX) {
		description_fault(&described->file, described->at, NULL,
				  "more than %d fixtures and parts, tools or offsets are not supported", BODIES_MAX);
		return false;
	}
	setup->offsets = arena_alloc(&setup->arena, described->offset_count * sizeof(*setup->offsets));
	setup->tools = arena_alloc(&setup->arena, tools * sizeof(*setup->tools));
	setup->edges = arena_alloc(&setup->arena, described->edge_count * sizeof(*setup->edges));
	setup->lengths = arena_alloc(&setup->arena, (tools + lengths) * sizeof(*setup->lengths));
	setup->radii = arena_alloc(&setup->arena, lengths * sizeof(*setup->radii));
	setup->libraries = arena_alloc(&setup->arena, described->library_count * sizeof(*setup->libraries));
	setup->bodies = arena_alloc(&setup->arena, (mounted + TOOL_BODIES_MAX * tools) * sizeof(*setup->bodies));
	return true;
}

/* One message is enough: reported at the first body and the first tool only. */
static void check_mounts(struct setup_description *described, const struct machine *machine)
{
	if (described->body_count > 0 && !machine->workholding.present)
		description_fault(&described->file, described->bodies[0].at, NULL,
				  "the machine has no <workholding>, which a <%s> needs",
				  body_roles[described->bodies[0].role]);
	if (described->tool_count > 0 && !machine->spindle.present)
		description_fault(&described->file, described->tools[0].at, NULL,
				  "the machine has no <spindle>, which a <tool> needs");
}

static void build_content(struct setup_description *described, const struct machine *machine, struct setup *setup,
			  struct diag *diag)
{
	struct description_file *file = &described->file;
	struct tool_builder tools = {.file = file, .machine = machine, .setup = setup, .diag = diag};

	for (size_t i = 0; i < described->library_count; i++)
		setup->libraries[setup->library_count++] = described->libraries[i].path;
	for (size_t i = 0; i < described->offset_count; i++)
		build_work_offset(file, &described->offsets[i], machine, setup);
	for (size_t i = 0; i < described->length_count; i++)
		build_length(file, &described->lengths[i], machine, setup);
	for (size_t i = 0; i < described->body_count; i++)
		build_mounted(file, &described->bodies[i], machine, setup);
	for (size_t i = 0; i < described->tool_count; i++)
		tool_build(&tools, &described->tools[i]);
	for (size_t i = 0; i < described->edge_count; i++)
		build_edge(file, &described->edges[i], setup);
	add_tool_lengths(setup);
	variable_build_setup(described, machine, setup);
	if (described->initial_tool > TOOL_NUMBER_MAX)
		description_fault(file, described->at, "initial_tool",
				  "initial_tool=\"%s\" of <setup> is not between 0 and %d",
				  description_quote(file, described->at, "initial_tool").text, TOOL_NUMBER_MAX);
	else if (described->initial_tool && !setup_tool(setup, (int)described->initial_tool))
		description_fault(file, described->at, "initial_tool",
				  "initial_tool=\"%ld\" of <setup>: there is no such tool", described->initial_tool);
	else
		setup->initial_tool = (int)described->initial_tool;
}

struct setup *setup_build(struct setup_description *described, const struct machine *machine, struct diag *diag)
{
	struct setup *setup = mem_zalloc(1, sizeof(*setup));

	setup->arena = described->arena;
	described->arena = (struct arena){0};
	setup->path = arena_strdup(&setup->arena, described->file.path);
	check_mounts(described, machine);
	if (make_room(described, setup))
		build_content(described, machine, setup, diag);
	if (described->file.faults == 0)
		return setup;
	setup_free(setup);
	return NULL;
}
