#include "machine/xml/setup_xml.h"

#include <string.h>

#include "machine/library/setup_library.h"
#include "machine/setup_build.h"
#include "machine/xml/body_xml.h"
#include "machine/xml/variable_xml.h"
#include "machine/xml/xml_attribute.h"
#include "machine/xml/xml_element.h"

static const char *const elements[] = {SETUP_XML_ELEMENTS, NULL};

static void read_work_offset(struct xml_reader *xml, const xmlNode *node, void *context)
{
	struct setup_description *described = context;
	struct work_offset_description *offset = &described->offsets[described->offset_count++];
	const char *name = xml_attribute(xml, node, "name");

	xml_require(xml, node, "name", NULL);
	offset->at = node;
	offset->name = arena_strdup(&described->arena, name ? name : "");
	offset->checked = xml_name(xml, node, "checked", &described->arena);
	xml_axis_values(xml, node, offset->value);
	xml_read_nothing(xml, node);
}

static void read_length(struct xml_reader *xml, const xmlNode *node, void *context)
{
	struct setup_description *described = context;
	struct length_offset_description *offset = &described->lengths[described->length_count++];

	xml_require(xml, node, "number", NULL);
	offset->at = node;
	offset->number = xml_positive(xml, node, "number", 1);
	offset->length = xml_optional_length(xml, node, "length");
	offset->radius = xml_optional_length(xml, node, "radius");
	xml_read_nothing(xml, node);
}

static void read_fixture(struct xml_reader *xml, const xmlNode *node, void *context)
{
	struct setup_description *described = context;
	struct body_description *body = &described->bodies[described->body_count++];

	body->role = ROLE_FIXTURE;
	body_xml_read(xml, node, &described->arena, body);
}

static void read_part(struct xml_reader *xml, const xmlNode *node, void *context)
{
	struct setup_description *described = context;
	struct body_description *body = &described->bodies[described->body_count++];

	body->role = ROLE_PART;
	body->rapid_allowance = xml_optional_length(xml, node, "rapid_allowance");
	body->gouge = xml_optional_length(xml, node, "gouge");
	body_xml_read(xml, node, &described->arena, body);
}

/* Exactly one of mesh, box and cylinder is the shape. */
static void read_stock_shape(struct xml_reader *xml, const xmlNode *node, struct body_description *body)
{
	const bool mesh = xml_attribute(xml, node, "mesh"), box = xml_attribute(xml, node, "box"),
		   cylinder = xml_attribute(xml, node, "cylinder");

	if (mesh + box + cylinder != 1)
		xml_error(xml, node, NULL, "<stock> needs exactly one of mesh, box and cylinder");
	body->shape = box ? STOCK_BOX : cylinder ? STOCK_CYLINDER : STOCK_MESH;
	if (box)
		body->size = xml_point(xml, node, "box");
	if (cylinder)
		xml_two_lengths(xml, node, "cylinder", &body->size.x, &body->size.z);
	if (!mesh && xml_attribute(xml, node, "units"))
		xml_error(xml, node, "units", "<stock> has units, but no mesh to which they apply");
}

static void read_stock(struct xml_reader *xml, const xmlNode *node, void *context)
{
	struct setup_description *described = context;
	struct body_description *body = &described->bodies[described->body_count++];
	const char *name = xml_name(xml, node, "name", &described->arena);

	body->at = node;
	body->role = ROLE_STOCK;
	body->name = name ? name : arena_strdup(&described->arena, body_roles[ROLE_STOCK]);
	body->checked = xml_name(xml, node, "checked", &described->arena);
	body->rapid_allowance = xml_optional_length(xml, node, "rapid_allowance");
	body->uncertainty = xml_optional_length(xml, node, "uncertainty");
	body->excess = xml_optional_length(xml, node, "excess");
	read_stock_shape(xml, node, body);
	body->frame = xml_frame(xml, node);
	body->mesh_path = body_xml_mesh(xml, node, &described->arena);
	body->scale = xml_mesh_units(xml, node, xml->unit);
	xml_read_nothing(xml, node);
}

/* ------------------------------------------------------------------- tools */

static void read_section(struct xml_reader *xml, const xmlNode *node, void *context)
{
	struct piece_description *piece = context;
	struct section_description *section = &piece->sections[piece->section_count++];

	xml_require(xml, node, "length", "diameter", NULL);
	section->at = node;
	section->length = xml_length(xml, node, "length", 0);
	section->diameter = xml_length(xml, node, "diameter", 0);
	section->diameter_end = xml_optional_length(xml, node, "diameter_end");
	xml_read_nothing(xml, node);
}

/* The tool whose pieces are being read, and the arena for its strings. */
struct tool_context {
	struct tool_description *tool;
	struct arena *arena;
	struct setup_description *described;
};

static void read_piece(struct xml_reader *xml, const xmlNode *node, struct piece_description *piece,
		       struct arena *arena)
{
	static const struct xml_child children[] = {{"section", read_section, false, false}, {.name = NULL}};

	piece->at = node;
	piece->mesh_path = body_xml_mesh(xml, node, arena);
	piece->scale = xml_mesh_units(xml, node, xml->unit);
	piece->has_units = xml_attribute(xml, node, "units") != NULL;
	piece->sections = arena_alloc(arena, xml_count(node, "section") * sizeof(*piece->sections));
	xml_read_children(xml, node, children, piece);
}

/* An additional edge of a tool. */
static void read_edge(struct xml_reader *xml, const xmlNode *node, void *context)
{
	const struct tool_context *tool = context;
	struct edge_description *edge = &tool->described->edges[tool->described->edge_count++];

	xml_require(xml, node, "number", "length", NULL);
	edge->at = node;
	edge->tool = tool->tool->number;
	edge->number = xml_positive(xml, node, "number", 1);
	edge->length = xml_length(xml, node, "length", 0);
	edge->diameter = xml_optional_length(xml, node, "diameter");
	xml_read_nothing(xml, node);
}

static void read_holder(struct xml_reader *xml, const xmlNode *node, void *context)
{
	const struct tool_context *tool = context;

	read_piece(xml, node, &tool->tool->pieces[PIECE_HOLDER], tool->arena);
}

static void read_shank(struct xml_reader *xml, const xmlNode *node, void *context)
{
	const struct tool_context *tool = context;

	read_piece(xml, node, &tool->tool->pieces[PIECE_SHANK], tool->arena);
}

static void read_cutter(struct xml_reader *xml, const xmlNode *node, void *context)
{
	static const char *const tips[] = {
		[TIP_FLAT] = "flat", [TIP_BALL] = "ball", [TIP_CONE] = "cone", [TIP_BULL] = "bull", NULL,
	};
	const struct tool_context *tool = context;
	struct piece_description *piece = &tool->tool->pieces[PIECE_CUTTER];

	piece->has_tip = xml_attribute(xml, node, "tip") != NULL;
	piece->tip = (enum tool_tip)xml_choice(xml, node, "tip", tips, TIP_FLAT);
	piece->angle = xml_optional_angle(xml, node, "angle");
	piece->corner = xml_optional_length(xml, node, "corner");
	piece->flute_length = xml_optional_length(xml, node, "flute_length");
	read_piece(xml, node, piece, tool->arena);
}

static void read_tool(struct xml_reader *xml, const xmlNode *node, void *context)
{
	static const struct xml_child children[] = {{"holder", read_holder, true, false},
						    {"shank", read_shank, true, false},
						    {"cutter", read_cutter, true, false},
						    {"edge", read_edge, false, false},
						    {.name = NULL}};
	static const char *const names[] = {"cutter", "probe", "nozzle", "laser", "drag", NULL};
	static const enum tool_kind kinds[] = {TOOL_TURNS, TOOL_PROBES, TOOL_STANDS, TOOL_STANDS, TOOL_STANDS};
	static const char *const hands[] = {"right", "left", NULL};
	struct setup_description *described = context;
	struct tool_context tool = {&described->tools[described->tool_count++], &described->arena, described};

	xml_require(xml, node, "number", "length", NULL);
	tool.tool->at = node;
	tool.tool->number = xml_positive(xml, node, "number", 1);
	tool.tool->name = xml_label(xml, node, "name", tool.arena);
	tool.tool->checked = xml_name(xml, node, "checked", tool.arena);
	tool.tool->length = xml_length(xml, node, "length", 0);
	tool.tool->length_offset = xml_optional_length(xml, node, "length_offset");
	tool.tool->radius_offset = xml_optional_length(xml, node, "radius_offset");
	tool.tool->kind = kinds[xml_choice(xml, node, "kind", names, 0)];
	if (xml_attribute(xml, node, "hand"))
		tool.tool->hand = xml_choice(xml, node, "hand", hands, 0) ? HAND_LEFT : HAND_RIGHT;
	tool.tool->diameter = xml_optional_length(xml, node, "diameter");
	xml_read_children(xml, node, children, &tool);
}

/* ---------------------------------------------------------------- libraries */

static void read_library(struct xml_reader *xml, const xmlNode *node, void *context)
{
	struct setup_description *described = context;
	struct library_description *library = &described->libraries[described->library_count++];

	xml_require(xml, node, "href", NULL);
	library->at = node;
	library->path = body_xml_path(xml, node, "href", &described->arena);
	library->unit = xml_file_units(xml, node, xml->unit);
	library->numbers = xml_name(xml, node, "numbers", &described->arena);
	if (library->path && strstr(library->path, "://"))
		xml_error(xml, node, "href", "href of <tools> must be a file name, not an address");
	xml_read_nothing(xml, node);
}

static void read_variable(struct xml_reader *xml, const xmlNode *node, void *context)
{
	struct setup_description *described = context;

	variable_xml_read(xml, node, &described->arena, &described->variables[described->variable_count++]);
}

/* ------------------------------------------------------------------- setup */

static size_t count_edges(const xmlNode *setup)
{
	size_t count = 0;

	for (const xmlNode *child = setup->children; child; child = child->next)
		count += xml_count(child, "edge");
	return count;
}

void setup_xml_read(struct xml_reader *xml, const xmlNode *node, struct setup_description *described)
{
	static const char *const versions[] = {"1", NULL};
	static const struct xml_child children[] = {{"work_offset", read_work_offset, false, false},
						    {"offset", read_length, false, false},
						    {"fixture", read_fixture, false, false},
						    {"part", read_part, false, false},
						    {"stock", read_stock, true, false},
						    {"tool", read_tool, false, false},
						    {"tools", read_library, false, false},
						    {"variable", read_variable, false, false},
						    {.name = NULL}};
	struct arena *arena = &described->arena;
	const size_t bodies = xml_count(node, "fixture") + xml_count(node, "part") + xml_count(node, "stock");
	const double unit = xml->unit;

	described->file = xml_description_file(xml);
	described->at = node;
	xml_choice(xml, node, "version", versions, 0);
	xml->unit = xml_file_units(xml, node, unit);
	described->initial_tool = xml_whole(xml, node, "initial_tool", 0);
	described->offsets = arena_alloc(arena, xml_count(node, "work_offset") * sizeof(*described->offsets));
	described->lengths = arena_alloc(arena, xml_count(node, "offset") * sizeof(*described->lengths));
	described->bodies = arena_alloc(arena, bodies * sizeof(*described->bodies));
	described->tools = arena_alloc(arena, xml_count(node, "tool") * sizeof(*described->tools));
	described->edges = arena_alloc(arena, count_edges(node) * sizeof(*described->edges));
	described->variables = arena_alloc(arena, xml_count(node, "variable") * sizeof(*described->variables));
	described->libraries = arena_alloc(arena, xml_count(node, "tools") * sizeof(*described->libraries));
	xml_read_children(xml, node, children, described);
	if (!xml->errors && described->library_count)
		setup_library_add(described, xml->root, xml->diag);
	xml->unit = unit;
}

struct setup *setup_load(const char *path, const struct machine *machine, struct diag *diag)
{
	return setup_load_within(path, machine, NULL, diag);
}

struct setup *setup_load_within(const char *path, const struct machine *machine, const char *root, struct diag *diag)
{
	struct setup_description described = {.initial_tool = 0};
	struct setup *setup = NULL;
	struct xml_reader xml;

	if (!xml_open(&xml, path, elements, diag))
		return NULL;
	xml.root = root;
	xml_require(&xml, xml_root(&xml), "version", NULL);
	setup_xml_read(&xml, xml_root(&xml), &described);
	if (!xml.errors)
		setup = setup_build(&described, machine, diag);
	arena_release(&described.arena);
	xml_close(&xml);
	return setup;
}
