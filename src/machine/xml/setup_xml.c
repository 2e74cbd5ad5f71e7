#include "geom/tolerance.h"
#include "machine/tool_solid.h"
#include "machine/xml/setup_xml.h"

#include <string.h>

#include "base/mem.h"
#include "machine/xml/body_xml.h"
#include "machine/xml/tool_xml.h"

/* "G54.1 P7" and, the same, "G154 P7": P1 to P99. */
static bool is_extended_name(const char *name)
{
	const char *number = NULL;

	if (!strncmp(name, "G54.1 P", 7))
		number = name + 7;
	else if (!strncmp(name, "G154 P", 6))
		number = name + 6;
	return number && strlen(number) <= 2 && number[0] >= '1' && number[0] <= '9' &&
	       (!number[1] || (number[1] >= '0' && number[1] <= '9'));
}

static bool is_work_offset_name(const char *name)
{
	static const char *const names[] = {"G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"};

	for (size_t i = 0; i < sizeof(names) / sizeof(names[0]); i++)
		if (!strcmp(name, names[i]))
			return true;
	return is_extended_name(name);
}

static void read_work_offset(struct xml_reader *xml, const xmlNode *node, const struct machine *machine,
			     struct setup *setup)
{
	const char *name = xml_attribute(node, "name");
	struct work_offset offset = {.line = xmlGetLineNo(node)};

	if (!is_work_offset_name(name)) {
		xml_error(xml, node,
			  "name=\"%s\" of <work_offset> must be G54, G55, G56, G57, G58, G59, G59.1, G59.2, G59.3 or "
			  "G54.1 P1 to P99", xml_quote(name).text);
		return;
	}
	for (size_t i = 0; i < setup->offset_count; i++) {
		if (strcmp(setup->offsets[i].name, name) == 0) {
			xml_error(xml, node, "work offset %s is given twice (the other in line %ld)", name,
				  setup->offsets[i].line);
			return;
		}
	}
	offset.name = arena_strdup(&setup->arena, name);
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		const char letter[] = {AXIS_LETTERS[slot], '\0'};

		if (!xml_attribute(node, letter))
			continue;
		if (!machine_axis(machine, slot))
			xml_error(xml, node, "work offset %s has a value for %s, but the machine has no axis %s", name,
				  letter, letter);
		offset.value.v[slot] = slot_is_rotary(slot) ? xml_angle(xml, node, letter, 0)
							    : xml_length(xml, node, letter, 0);
	}
	setup->offsets[setup->offset_count++] = offset;
}

/* How deep a cutter may enter a part, at rapid and at feed. */
static void read_depths(struct xml_reader *xml, const xmlNode *node, struct body *body)
{
	static const char *const names[] = {"rapid_allowance", "gouge"};
	double *const depths[] = {&body->rapid_allowance, &body->gouge};

	body->rapid_allowance = RAPID_ALLOWANCE;
	body->gouge = -1;
	for (int i = 0; i < 2; i++) {
		if (!xml_attribute(node, names[i]))
			continue;
		*depths[i] = xml_length(xml, node, names[i], 0);
		if (*depths[i] < 0 || *depths[i] > TOOL_SIZE_MAX)
			xml_error(xml, node, "%s=\"%s\" of <part> is not between 0 and %g mm", names[i],
				  xml_quote(xml_attribute(node, names[i])).text, TOOL_SIZE_MAX);
	}
}

/* A <fixture> or <part>. */
static void read_mounted(struct xml_reader *xml, const xmlNode *node, const struct machine *machine,
			 struct setup *setup)
{
	struct body body = {.role = xml_is(node, "part") ? ROLE_PART : ROLE_FIXTURE,
			    .link = machine->workholding.link,
			    .loc = {.file = setup->path, .line = xmlGetLineNo(node)}};

	if (!body_read(xml, node, &setup->arena, &machine->workholding.frame, &body))
		return;
	if (body.role == ROLE_PART)
		read_depths(xml, node, &body);
	body_check_name(xml, node, body.name, machine->bodies, machine->body_count);
	body_check_name(xml, node, body.name, setup->bodies, setup->body_count);
	setup->bodies[setup->body_count++] = body;
}

static void read_length(struct xml_reader *xml, const xmlNode *node, struct setup *setup)
{
	int number = xml_integer(xml, node, "number", 0, 1, TOOL_NUMBER_MAX);

	for (size_t i = 0; i < setup->length_count; i++)
		if (setup->lengths[i].number == number && number)
			xml_error(xml, node, "<offset> %d is given twice", number);
	setup->lengths[setup->length_count++] =
		(struct length_offset){.number = number, .length = xml_length(xml, node, "length", 0)};
}

/* Every tool has the H of its number, unless an <offset> gave it. */
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

/* Room for everything; false if there is too much of it. */
static bool make_room(struct xml_reader *xml, const xmlNode *node, struct setup *setup)
{
	size_t tools = xml_count(node, "tool"), lengths = xml_count(node, "offset");
	size_t offsets = xml_count(node, "work_offset"), mounted = xml_count(node, "fixture") + xml_count(node, "part");

	if (mounted > BODIES_MAX || tools > BODIES_MAX || lengths > BODIES_MAX) {
		xml_error(xml, node, "more than %d fixtures and parts, tools or offsets are not supported", BODIES_MAX);
		return false;
	}
	setup->offsets = arena_alloc(&setup->arena, offsets * sizeof(*setup->offsets));
	setup->tools = arena_alloc(&setup->arena, tools * sizeof(*setup->tools));
	setup->lengths = arena_alloc(&setup->arena, (tools + lengths) * sizeof(*setup->lengths));
	setup->bodies = arena_alloc(&setup->arena, (mounted + TOOL_BODIES_MAX * tools) * sizeof(*setup->bodies));
	return true;
}

static void check_mounts(struct xml_reader *xml, const xmlNode *root, const struct machine *machine)
{
	bool mounted = false, tools = false;

	for (const xmlNode *node = xml_first(root); node; node = xml_next(node)) {
		if ((xml_is(node, "fixture") || xml_is(node, "part")) && !machine->workholding.present && !mounted) {
			xml_error(xml, node, "the machine has no <workholding> for a <%s>", (const char *)node->name);
			mounted = true;
		}
		if (xml_is(node, "tool") && !machine->spindle.present && !tools) {
			xml_error(xml, node, "the machine has no <spindle> for a <tool>");
			tools = true;
		}
	}
}

static void read_content(struct xml_reader *xml, const xmlNode *root, const struct machine *machine,
			 struct setup *setup)
{
	struct tool_reader tools = {.xml = xml, .setup = setup, .machine = machine};

	for (const xmlNode *node = xml_first(root); node; node = xml_next(node)) {
		if (xml_is(node, "work_offset"))
			read_work_offset(xml, node, machine, setup);
		else if (xml_is(node, "offset"))
			read_length(xml, node, setup);
		else if (xml_is(node, "fixture") || xml_is(node, "part"))
			read_mounted(xml, node, machine, setup);
	}
	for (const xmlNode *node = xml_first(root); node; node = xml_next(node))
		if (xml_is(node, "tool"))
			tool_read(&tools, node);
	add_tool_lengths(setup);
	setup->initial_tool = xml_integer(xml, root, "initial_tool", 0, 0, TOOL_NUMBER_MAX);
	if (setup->initial_tool && !setup_tool(setup, setup->initial_tool))
		xml_error(xml, root, "initial_tool=\"%d\" of <setup>: there is no such tool", setup->initial_tool);
}

struct setup *setup_read(struct xml_reader *xml, const xmlNode *node, const struct machine *machine)
{
	struct setup *setup = mem_zalloc(1, sizeof(*setup));
	double unit = xml->unit;
	size_t errors = xml->errors;

	setup->path = arena_strdup(&setup->arena, xml->path);
	xml->unit = xml_units(node, unit);
	check_mounts(xml, node, machine);
	if (make_room(xml, node, setup))
		read_content(xml, node, machine, setup);
	xml->unit = unit;
	if (xml->errors == errors)
		return setup;
	setup_free(setup);
	return NULL;
}

struct setup *setup_load(const char *path, const struct machine *machine, struct diag *diag)
{
	struct xml_reader xml;
	struct setup *setup;

	if (!xml_open(&xml, path, "setup", diag))
		return NULL;
	setup = setup_read(&xml, xml_root(&xml), machine);
	xml_close(&xml);
	return setup;
}
