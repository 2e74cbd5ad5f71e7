#include "machine/xml/tool_xml.h"

#include <math.h>

#include "base/strbuf.h"
#include "base/units.h"
#include "machine/xml/body_xml.h"
#include "machine/tool_solid.h"

/* Sections must add up to the tool's length within this, mm. */
#define SUM_TOLERANCE 1e-6
/* How much, mm, a tip may be higher than its section: written decimals do not always fit. */
#define TIP_TOLERANCE 1e-6
#define SECTIONS_MAX 1000
#define CONE_MIN 1.0
#define CONE_MAX 179.0

/* From the gauge line down. */
enum { HOLDER, SHANK, CUTTER, PIECES };

static const char *const piece_names[PIECES] = {"holder", "shank", "cutter"};
static const enum body_role piece_roles[PIECES] = {ROLE_HOLDER, ROLE_SHANK, ROLE_CUTTER};

struct piece {
	const xmlNode *node;	/* NULL: the tool has no such piece */
	bool mesh;
	struct tool_solid solid;	/* unless it is a mesh */
	double length;	/* of its sections */
	double flutes;	/* mm of a cutter, from its end, that cut; 0: all of it */
};

static double read_diameter(struct xml_reader *xml, const xmlNode *node, const char *name, double least,
			    double fallback)
{
	double d = xml_length(xml, node, name, fallback);

	if (d >= least && d <= TOOL_SIZE_MAX && (d == 0 || d >= TOOL_DIAMETER_MIN))
		return d;
	xml_error(xml, node, "%s=\"%s\" of <section> is not between %g and %g mm%s", name,
		  xml_quote(xml_attribute(node, name)).text, TOOL_DIAMETER_MIN, TOOL_SIZE_MAX,
		  least > 0 ? "" : ", nor 0");
	return TOOL_DIAMETER_MIN;
}

static struct tool_section read_section(struct xml_reader *xml, const xmlNode *node)
{
	struct tool_section section;

	section.length = xml_length(xml, node, "length", TOOL_SECTION_MIN);
	section.diameter = read_diameter(xml, node, "diameter", TOOL_DIAMETER_MIN, TOOL_DIAMETER_MIN);
	section.diameter_end = section.diameter;
	if (xml_attribute(node, "diameter_end"))
		section.diameter_end = read_diameter(xml, node, "diameter_end", 0, section.diameter);
	if (section.length < TOOL_SECTION_MIN || section.length > TOOL_SIZE_MAX) {
		xml_error(xml, node, "length=\"%s\" of <section> is not between %g and %g mm",
			  xml_quote(xml_attribute(node, "length")).text, TOOL_SECTION_MIN, TOOL_SIZE_MAX);
		section.length = TOOL_SECTION_MIN;
	}
	return section;
}

static void read_cone(struct xml_reader *xml, const xmlNode *node, struct tool_solid *solid)
{
	const char *text = xml_attribute(node, "angle");
	double angle = degrees(xml_angle(xml, node, "angle", PI / 2));

	solid->angle = PI / 2;
	if (!text)
		xml_error(xml, node, "<cutter> with tip=\"cone\" needs an angle, the full angle of the point");
	else if (angle < CONE_MIN || angle > CONE_MAX)
		xml_error(xml, node, "angle=\"%s\" of <cutter> is not between %g and %g degrees", xml_quote(text).text,
			  CONE_MIN, CONE_MAX);
	else
		solid->angle = radians(angle);
}

static void read_bull(struct xml_reader *xml, const xmlNode *node, double radius, struct tool_solid *solid)
{
	const char *text = xml_attribute(node, "corner");

	solid->corner = xml_length(xml, node, "corner", 0);
	if (!text)
		xml_error(xml, node, "<cutter> with tip=\"bull\" needs a corner, the radius of its rounded edge");
	else if (solid->corner <= 0 || solid->corner > radius + TIP_TOLERANCE)
		xml_error(xml, node,
			  "corner=\"%s\" of <cutter> is not between 0 and the radius of its last section, %.9g mm",
			  xml_quote(text).text, radius);
	solid->corner = fmin(solid->corner, radius);
}

/* The tip of a cutter; it must fit its last section. */
static void read_tip(struct xml_reader *xml, const xmlNode *node, struct tool_solid *solid)
{
	static const char *const tips[] = {"flat", "ball", "cone", "bull", NULL};
	const struct tool_section *last = &solid->sections[solid->count - 1];
	size_t errors = xml->errors;
	double height;

	solid->tip = (enum tool_tip)xml_choice(node, "tip", tips);
	if (solid->tip == TIP_CONE)
		read_cone(xml, node, solid);
	else if (xml_attribute(node, "angle"))
		xml_error(xml, node, "<cutter>: only tip=\"cone\" has an angle");
	if (solid->tip == TIP_BULL)
		read_bull(xml, node, last->diameter / 2, solid);
	else if (xml_attribute(node, "corner"))
		xml_error(xml, node, "<cutter>: only tip=\"bull\" has a corner");
	if (solid->tip == TIP_FLAT || xml->errors > errors)
		return;
	if (last->diameter != last->diameter_end) {
		xml_error(xml, node, "<cutter> with tip=\"%s\": its last section must be a cylinder", tips[solid->tip]);
		return;
	}
	height = tool_solid_tip_height(solid);
	if (height > last->length + TIP_TOLERANCE)
		xml_error(xml, node, "<cutter>: the %s tip is %.9g mm high, but the last section is %.9g mm long",
			  tips[solid->tip], height, last->length);
}

static void read_sections(struct tool_reader *reader, const xmlNode *node, struct piece *piece)
{
	size_t count = xml_count(node, "section"), filled = 0;
	struct tool_section *sections;

	if (count > SECTIONS_MAX) {
		xml_error(reader->xml, node, "<%s> has %zu sections; more than %d are not supported",
			  (const char *)node->name, count, SECTIONS_MAX);
		return;
	}
	sections = arena_alloc(&reader->setup->arena, count * sizeof(*sections));
	for (const xmlNode *child = xml_first(node); child; child = xml_next(child)) {
		sections[filled] = read_section(reader->xml, child);
		piece->length += sections[filled++].length;
	}
	piece->solid.sections = sections;
	piece->solid.count = count;
}

/* How much of a cutter cuts: what is above its flutes rubs, and is a body of its own. */
static void read_flutes(struct xml_reader *xml, const xmlNode *node, struct piece *piece)
{
	const char *text = xml_attribute(node, "flute_length");
	double flutes, least;

	if (!text)
		return;
	flutes = xml_length(xml, node, "flute_length", 0);
	least = fmax(tool_solid_tip_height(&piece->solid), TOOL_SECTION_MIN);
	if (flutes < least - TIP_TOLERANCE || flutes > piece->length + SUM_TOLERANCE)
		xml_error(xml, node,
			  "flute_length=\"%s\" of <cutter> is not between the height of its tip and its length, %.9g and "
			  "%.9g mm",
			  xml_quote(text).text, least, piece->length);
	else if (flutes < piece->length - TOOL_SECTION_MIN)
		piece->flutes = fmax(flutes, least);
}

static void read_piece(struct tool_reader *reader, const xmlNode *node, struct piece *piece)
{
	bool cutter = xml_is(node, "cutter");

	piece->node = node;
	piece->mesh = xml_attribute(node, "mesh") != NULL;
	if (piece->mesh && xml_first(node)) {
		xml_error(reader->xml, node, "<%s> has both a mesh and sections", (const char *)node->name);
		return;
	}
	if (piece->mesh) {
		if (xml_attribute(node, "tip") || xml_attribute(node, "angle") || xml_attribute(node, "corner") ||
		    xml_attribute(node, "flute_length"))
			xml_error(reader->xml, node,
				  "<cutter> with a mesh has its tip there: remove tip, angle, corner and flute_length");
		return;
	}
	if (!xml_first(node)) {
		xml_error(reader->xml, node, "<%s> needs sections, or a mesh", (const char *)node->name);
		return;
	}
	if (xml_attribute(node, "units"))
		xml_error(reader->xml, node, "<%s>: units are those of a mesh, and it has none",
			  (const char *)node->name);
	read_sections(reader, node, piece);
	if (!cutter || !piece->solid.count)
		return;
	read_tip(reader->xml, node, &piece->solid);
	read_flutes(reader->xml, node, piece);
}

/* Sections hang below what ends at a known height, or stand on what begins at one. */
static void stack(struct tool_reader *reader, const xmlNode *node, struct piece pieces[PIECES], double length)
{
	double top = 0, tip = -length;
	int first = HOLDER, last = CUTTER;

	for (; first < PIECES && !pieces[first].mesh; first++) {
		pieces[first].solid.top = top;
		top -= pieces[first].length;
	}
	if (first == PIECES) {
		if (fabs(top + length) > SUM_TOLERANCE)
			xml_error(reader->xml, node,
				  "the sections of tool %d add up to %.9g mm, but its length is %.9g mm",
				  xml_integer(reader->xml, node, "number", 0, 0, TOOL_NUMBER_MAX), -top, length);
		return;
	}
	for (; last > first && !pieces[last].mesh; last--) {
		tip += pieces[last].length;
		pieces[last].solid.top = tip;
	}
	if (last - first == 2 && pieces[SHANK].node && !pieces[SHANK].mesh)
		xml_error(reader->xml, pieces[SHANK].node, "<shank> stands between two meshes: give it a mesh too");
	if (-top > length + SUM_TOLERANCE || tip > SUM_TOLERANCE)
		xml_error(reader->xml, node, "the sections of tool %d are longer than the tool",
			  xml_integer(reader->xml, node, "number", 0, 0, TOOL_NUMBER_MAX));
}

/* The pose that brings the gauge point from the origin to the spindle, and the tip from -Z into its direction. */
static xform tool_placement(const struct spindle *spindle)
{
	vec3 from = {0, 0, -1}, to = spindle->direction, axis = vec3_cross(from, to);
	double sine = vec3_norm(axis);
	xform placement = {mat3_identity(), spindle->location};

	if (sine > 1e-12)
		placement.rotation = mat3_turn(vec3_scale(1 / sine, axis), atan2(sine, vec3_dot(from, to)));
	else if (vec3_dot(from, to) < 0)
		placement.rotation = (mat3){{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
	return placement;
}

static const struct mesh *tessellate(struct tool_reader *reader, const xmlNode *node, const struct tool_solid *solid)
{
	struct mesh *mesh;
	size_t triangles = tool_solid_triangles(solid);

	if (triangles > TOOL_TRIANGLES_MAX - reader->triangles) {
		xml_error(reader->xml, node, "the tools' sections make more than %zu triangles", TOOL_TRIANGLES_MAX);
		return NULL;
	}
	reader->triangles += triangles;
	mesh = arena_alloc(&reader->setup->arena, sizeof(*mesh));
	tool_solid_mesh(solid, &reader->setup->arena, mesh);
	return mesh;
}

static const char *piece_name(struct arena *arena, int number, const char *what)
{
	struct strbuf text = {0};
	const char *name;

	strbuf_addf(&text, "T%d %s", number, what);
	name = arena_strdup(arena, strbuf_text(&text));
	strbuf_release(&text);
	return name;
}

/* A piece of a tool that is a body: a mesh where `solid` is NULL. */
static void add_body(struct tool_reader *reader, const struct tool *tool, const xmlNode *node, const char *what,
		     enum body_role role, const struct tool_solid *solid)
{
	const struct machine *machine = reader->machine;
	struct setup *setup = reader->setup;
	struct body body = {.name = piece_name(&setup->arena, tool->number, what),
			    .role = role,
			    .link = machine->spindle.link,
			    .tool = tool->number,
			    .scale = 1,
			    .placement = tool_placement(&machine->spindle),
			    .loc = {.file = setup->path, .line = xmlGetLineNo(node)}};

	if (!solid)
		body_read_mesh(reader->xml, node, &setup->arena, &body);
	else if (!reader->xml->errors)
		body.solid = tessellate(reader, node, solid);
	if (solid && role == ROLE_CUTTER) {
		struct tool_solid *profile = arena_alloc(&setup->arena, sizeof(*profile));

		*profile = *solid;
		body.profile = profile;
	}
	body_check_name(reader->xml, node, body.name, machine->bodies, machine->body_count);
	body_check_name(reader->xml, node, body.name, setup->bodies, setup->body_count);
	setup->bodies[setup->body_count++] = body;
}

static void add_bodies(struct tool_reader *reader, const struct tool *tool, const struct piece pieces[PIECES])
{
	for (int i = 0; i < PIECES; i++) {
		const struct piece *piece = &pieces[i];
		struct tool_solid neck, flutes;

		if (!piece->node)
			continue;
		if (!(piece->flutes > 0)) {
			add_body(reader, tool, piece->node, piece_names[i], piece_roles[i],
				 piece->mesh ? NULL : &piece->solid);
			continue;
		}
		tool_solid_cut(&piece->solid, piece->flutes, &reader->setup->arena, &neck, &flutes);
		add_body(reader, tool, piece->node, "neck", ROLE_SHANK, &neck);
		add_body(reader, tool, piece->node, piece_names[i], piece_roles[i], &flutes);
	}
}

/* The cutter's greatest diameter; of a mesh, what the file says, if anything. */
static double read_tool_diameter(struct xml_reader *xml, const xmlNode *node, const struct piece *cutter)
{
	double given = xml_length(xml, node, "diameter", 0), largest = 0;

	for (size_t i = 0; i < cutter->solid.count; i++)
		largest =
		    fmax(largest, fmax(cutter->solid.sections[i].diameter, cutter->solid.sections[i].diameter_end));
	if (!xml_attribute(node, "diameter"))
		return largest;
	if (given <= 0 || given > TOOL_SIZE_MAX)
		xml_error(xml, node, "diameter=\"%s\" of <tool> is not between 0 and %g mm",
			  xml_quote(xml_attribute(node, "diameter")).text, TOOL_SIZE_MAX);
	else if (largest > 0 && fabs(given - largest) > SUM_TOLERANCE)
		xml_error(xml, node, "diameter=\"%s\" of <tool>: the greatest diameter of its cutter is %.9g mm",
			  xml_quote(xml_attribute(node, "diameter")).text, largest);
	return given;
}

void tool_read(struct tool_reader *reader, const xmlNode *node)
{
	struct xml_reader *xml = reader->xml;
	struct setup *setup = reader->setup;
	const char *name = xml_label(xml, node, "name", &setup->arena);
	static const char *const kinds[] = {"cutter", "probe", "nozzle", "laser", "drag", NULL};
	struct piece pieces[PIECES] = {{0}};
	struct tool tool = {.number = xml_integer(xml, node, "number", 0, 1, TOOL_NUMBER_MAX),
			    .name = name ? name : "",
			    .length = xml_length(xml, node, "length", 1),
			    .kind = xml_choice(node, "kind", kinds) ? TOOL_STANDS : TOOL_TURNS,
			    .line = xmlGetLineNo(node)};
	const struct tool *other = setup_tool(setup, tool.number);
	size_t errors = xml->errors;

	if (other) {
		xml_error(xml, node, "tool %d is given twice (the other in line %ld)", tool.number, other->line);
		return;
	}
	tool.length_offset = xml_length(xml, node, "length_offset", tool.length);
	if (tool.length <= 0 || tool.length > TOOL_SIZE_MAX) {
		xml_error(xml, node, "length=\"%s\" of <tool> is not between 0 and %g mm",
			  xml_quote(xml_attribute(node, "length")).text, TOOL_SIZE_MAX);
		return;
	}
	for (const xmlNode *child = xml_first(node); child; child = xml_next(child))
		for (int i = 0; i < PIECES; i++)
			if (xml_is(child, piece_names[i]))
				read_piece(reader, child, &pieces[i]);
	tool.diameter = read_tool_diameter(xml, node, &pieces[CUTTER]);
	if (!xml_first(node))
		diag_warning(xml->diag, (struct srcloc){.file = setup->path, .line = tool.line},
			     "tool %d has neither holder nor shank nor cutter: nothing of it is checked", tool.number);
	else if (xml->errors == errors)
		stack(reader, node, pieces, tool.length);
	setup->tools[setup->tool_count++] = tool;
	add_bodies(reader, &tool, pieces);
}
