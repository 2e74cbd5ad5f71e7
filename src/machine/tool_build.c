#include "machine/tool_build.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/same_double.h"
#include "base/strbuf.h"
#include "base/units.h"
#include "geom/tolerance.h"
#include "machine/body_build.h"
#include "machine/tool_solid.h"

#define SECTIONS_MAX 1000
/* Degrees: the full angle of a cone's point. */
#define CONE_MIN 1.0
#define CONE_MAX 179.0

static const char *const piece_names[TOOL_PIECES] = {"holder", "shank", "cutter"};
static const enum body_role piece_roles[TOOL_PIECES] = {ROLE_HOLDER, ROLE_SHANK, ROLE_CUTTER};

struct piece {
	const struct piece_description *described;
	bool cutter;
	const char *name;
	struct tool_solid solid;	/* without sections: the piece is a mesh, or there is none */
	double length;	/* of its sections */
	double flutes;	/* mm from the cutter's end: the length of the part that cuts; 0: all of it */
};

/* --------------------------------------------------------------- sections */

static double build_diameter(struct description_file *file, const void *at, const char *name, double least, double d)
{
	if (d >= least && d <= TOOL_SIZE_MAX && (d <= 0 || d >= TOOL_DIAMETER_MIN))
		return d;
	description_fault(file, at, name, "%s=\"%s\" of <section> is not between %g and %g mm%s", name,
			  description_quote(file, at, name).text, TOOL_DIAMETER_MIN, TOOL_SIZE_MAX,
			  least > 0 ? "" : " and not 0");
	return TOOL_DIAMETER_MIN;
}

static struct tool_section build_section(struct description_file *file, const struct section_description *described)
{
	const void *at = described->at;
	struct tool_section section = {.length = described->length};

	section.diameter = build_diameter(file, at, "diameter", TOOL_DIAMETER_MIN, described->diameter);
	section.diameter_end = section.diameter;
	if (described->diameter_end.given)
		section.diameter_end = build_diameter(file, at, "diameter_end", 0, described->diameter_end.value);
	if (section.length < TOOL_SECTION_MIN || section.length > TOOL_SIZE_MAX) {
		description_fault(file, at, "length", "length=\"%s\" of <section> is not between %g and %g mm",
				  description_quote(file, at, "length").text, TOOL_SECTION_MIN, TOOL_SIZE_MAX);
		section.length = TOOL_SECTION_MIN;
	}
	return section;
}

static void build_sections(struct tool_builder *builder, struct piece *piece)
{
	const struct piece_description *described = piece->described;
	struct tool_section *sections;

	if (described->section_count > SECTIONS_MAX) {
		description_fault(builder->file, described->at, NULL,
				  "<%s> has %zu sections; more than %d are not supported", piece->name,
				  described->section_count, SECTIONS_MAX);
		return;
	}
	sections = arena_alloc(&builder->setup->arena, described->section_count * sizeof(*sections));
	for (size_t i = 0; i < described->section_count; i++) {
		sections[i] = build_section(builder->file, &described->sections[i]);
		piece->length += sections[i].length;
	}
	piece->solid.sections = sections;
	piece->solid.count = described->section_count;
}

/* -------------------------------------------------------------------- tip */

static void build_cone(struct description_file *file, const struct piece_description *described,
		       struct tool_solid *solid)
{
	double angle = degrees(described->angle.value);

	solid->angle = PI / 2;
	if (!described->angle.given)
		description_fault(file, described->at, NULL,
				  "<cutter> with tip=\"cone\" needs an angle (full angle of the point)");
	else if (angle < CONE_MIN || angle > CONE_MAX)
		description_fault(file, described->at, "angle",
				  "angle=\"%s\" of <cutter> is not between %g and %g degrees",
				  description_quote(file, described->at, "angle").text, CONE_MIN, CONE_MAX);
	else
		solid->angle = radians(angle);
}

static void build_bull(struct description_file *file, const struct piece_description *described, double radius,
		       struct tool_solid *solid)
{
	solid->corner = described->corner.value;
	if (!described->corner.given)
		description_fault(file, described->at, NULL,
				  "<cutter> with tip=\"bull\" needs a corner (corner radius)");
	else if (solid->corner <= 0 || solid->corner > radius + TOOL_SUM_TOLERANCE)
		description_fault(
		    file, described->at, "corner",
		    "corner=\"%s\" of <cutter> is not between 0 and the radius of its last section, %.9g mm",
		    description_quote(file, described->at, "corner").text, radius);
	solid->corner = fmin(solid->corner, radius);
}

/* The tip of a cutter; it must fit its last section. */
static void build_tip(struct description_file *file, const struct piece_description *described,
		      struct tool_solid *solid)
{
	static const char *const tips[] = {"flat", "ball", "cone", "bull"};
	const struct tool_section *last = &solid->sections[solid->count - 1];
	const void *at = described->at;
	size_t faults = file->faults;
	double height;

	solid->tip = described->tip;
	if (solid->tip == TIP_CONE)
		build_cone(file, described, solid);
	else if (described->angle.given)
		description_fault(file, at, "angle", "<cutter>: only tip=\"cone\" has an angle");
	if (solid->tip == TIP_BULL)
		build_bull(file, described, last->diameter / 2, solid);
	else if (described->corner.given)
		description_fault(file, at, "corner", "<cutter>: only tip=\"bull\" has a corner");
	if (solid->tip == TIP_FLAT || file->faults > faults)
		return;
	if (!same_double(last->diameter, last->diameter_end)) {
		description_fault(file, at, "tip", "<cutter> with tip=\"%s\": its last section must be a cylinder",
				  tips[solid->tip]);
		return;
	}
	height = tool_solid_tip_height(solid);
	if (height > last->length + TOOL_SUM_TOLERANCE)
		description_fault(file, at, NULL,
				  "<cutter>: the %s tip is %.9g mm high, but the last section is %.9g mm long",
				  tips[solid->tip], height, last->length);
}

/* Separates the flutes of a cutter from its neck: the neck rubs, and is a body of its own. */
static void build_flutes(struct description_file *file, struct piece *piece)
{
	const struct piece_description *described = piece->described;
	double flutes = described->flute_length.value;
	double least = fmax(tool_solid_tip_height(&piece->solid), TOOL_SECTION_MIN);

	if (!described->flute_length.given)
		return;
	if (flutes < least - TOOL_SUM_TOLERANCE || flutes > piece->length + TOOL_SUM_TOLERANCE)
		description_fault(file, described->at, "flute_length",
				  "flute_length=\"%s\" of <cutter> is not between the height of its tip and its "
				  "length, %.9g and %.9g mm",
				  description_quote(file, described->at, "flute_length").text, least, piece->length);
	else if (flutes < piece->length - TOOL_SECTION_MIN)
		piece->flutes = fmax(flutes, least);
}

static void build_piece(struct tool_builder *builder, struct piece *piece)
{
	const struct piece_description *described = piece->described;
	struct description_file *file = builder->file;

	if (!described->at)
		return;
	if (described->mesh_path && described->section_count > 0) {
		description_fault(file, described->at, "mesh", "<%s> has both a mesh and sections", piece->name);
	} else if (described->mesh_path) {
		if (described->has_tip || described->angle.given || described->corner.given ||
		    described->flute_length.given)
			description_fault(file, described->at, NULL,
					  "<cutter> takes its tip from its mesh: remove tip, angle, corner and "
					  "flute_length");
	} else if (described->section_count == 0) {
		description_fault(file, described->at, NULL, "<%s> needs sections, or a mesh", piece->name);
	} else {
		if (described->has_units)
			description_fault(file, described->at, "units",
					  "<%s> has units, but no mesh to which they apply", piece->name);
		build_sections(builder, piece);
		if (piece->cutter && piece->solid.count) {
			build_tip(file, described, &piece->solid);
			build_flutes(file, piece);
		}
	}
}

/* Places sections downward or upward from a known height. */
static void stack(struct tool_builder *builder, const struct tool_description *described,
		  struct piece pieces[TOOL_PIECES])
{
	double top = 0, length = described->length, tip = -length;
	int first = PIECE_HOLDER, last = PIECE_CUTTER;

	for (; first < TOOL_PIECES && !pieces[first].described->mesh_path; first++) {
		pieces[first].solid.top = top;
		top -= pieces[first].length;
	}
	if (first == TOOL_PIECES) {
		if (fabs(top + length) > TOOL_SUM_TOLERANCE)
			description_fault(builder->file, described->at, "length",
					  "the sections of tool %ld add up to %.9g mm, but its length is %.9g mm",
					  described->number, -top, length);
		return;
	}
	for (; last > first && !pieces[last].described->mesh_path; last--) {
		tip += pieces[last].length;
		pieces[last].solid.top = tip;
	}
	if (last - first == 2 && pieces[PIECE_SHANK].described->at && !pieces[PIECE_SHANK].described->mesh_path)
		description_fault(builder->file, pieces[PIECE_SHANK].described->at, NULL,
				  "<shank> is between two meshes: give it a mesh too");
	if (-top > length + TOOL_SUM_TOLERANCE || tip > TOOL_SUM_TOLERANCE)
		description_fault(builder->file, described->at, "length",
				  "the sections of tool %ld are longer than the tool", described->number);
}

/* ----------------------------------------------------------------- bodies */

/*
 * The pose that moves the gauge point from the origin to the spindle, and rotates the tip from -Z to the spindle's
 * direction.
 */
static xform tool_placement(const struct spindle *spindle)
{
	vec3 from = {0, 0, -1}, to = spindle->direction, axis = vec3_cross(from, to);
	double sine = vec3_norm(axis);
	xform placement = {mat3_identity(), spindle->location};

	if (sine > PARALLEL_SINE)
		placement.rotation = mat3_turn(vec3_scale(1 / sine, axis), math_atan2(sine, vec3_dot(from, to)));
	else if (vec3_dot(from, to) < 0)
		placement.rotation = (mat3){{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
	return placement;
}

/* The scene makes the triangles when they are needed. */
static void count_triangles(struct tool_builder *builder, const void *at, const struct tool_solid *solid)
{
	size_t triangles = tool_solid_triangles(solid);

	if (triangles > TOOL_TRIANGLES_MAX - builder->triangles)
		description_fault(builder->file, at, NULL,
				  "the sections of the tools make more than %zu triangles: leave out the tools that "
				  "the job does not need",
				  TOOL_TRIANGLES_MAX);
	else
		builder->triangles += triangles;
}

static const char *body_name(struct arena *arena, int number, const char *what)
{
	struct strbuf text = {0};
	const char *name;

	strbuf_addf(&text, "T%d %s", number, what);
	name = arena_strdup(arena, strbuf_text(&text));
	strbuf_release(&text);
	return name;
}

/* Adds a piece of a tool as a body; `solid` NULL: the piece is a mesh. */
static void add_body(struct tool_builder *builder, const struct tool *tool, const struct piece_description *described,
		     const char *what, enum body_role role, const struct tool_solid *solid)
{
	const struct machine *machine = builder->machine;
	struct setup *setup = builder->setup;
	struct body body = {.name = body_name(&setup->arena, tool->number, what),
			    .role = role,
			    .link = machine->spindle.link,
			    .tool = tool->number,
			    .mesh_path = solid ? NULL : described->mesh_path,
			    .scale = solid ? 1 : described->scale,
			    .placement = tool_placement(&machine->spindle),
			    .loc = description_place(builder->file, described->at)};

	if (solid && builder->file->faults == 0)
		count_triangles(builder, described->at, solid);
	if (solid) {
		struct tool_solid *profile = arena_alloc(&setup->arena, sizeof(*profile));

		*profile = *solid;
		body.profile = profile;
	}
	body_check_name(builder->file, described->at, body.name, machine->bodies, machine->body_count);
	body_check_name(builder->file, described->at, body.name, setup->bodies, setup->body_count);
	setup->bodies[setup->body_count++] = body;
}

static void add_bodies(struct tool_builder *builder, const struct tool *tool, const struct piece pieces[TOOL_PIECES])
{
	for (int i = 0; i < TOOL_PIECES; i++) {
		const struct piece *piece = &pieces[i];
		const struct tool_solid *solid = piece->described->mesh_path ? NULL : &piece->solid;
		struct tool_solid neck, flutes;

		if (!piece->described->at)
			continue;
		if (piece->flutes > 0) {
			tool_solid_cut(&piece->solid, piece->flutes, &builder->setup->arena, &neck, &flutes);
			add_body(builder, tool, piece->described, "neck", ROLE_SHANK, &neck);
			solid = &flutes;
		}
		add_body(builder, tool, piece->described, piece->name, piece_roles[i], solid);
	}
}

/* The cutter's greatest diameter; for a mesh, the value in the file, if any. */
static double build_tool_diameter(struct description_file *file, const struct tool_description *described,
				  const struct piece *cutter)
{
	double given = described->diameter.value, largest = 0;

	for (size_t i = 0; i < cutter->solid.count; i++)
		largest =
		    fmax(largest, fmax(cutter->solid.sections[i].diameter, cutter->solid.sections[i].diameter_end));
	if (!described->diameter.given)
		return largest;
	if (given <= 0 || given > TOOL_SIZE_MAX)
		description_fault(file, described->at, "diameter",
				  "diameter=\"%s\" of <tool> is not between 0 and %g mm",
				  description_quote(file, described->at, "diameter").text, TOOL_SIZE_MAX);
	else if (largest > 0 && fabs(given - largest) > TOOL_SUM_TOLERANCE)
		description_fault(file, described->at, "diameter",
				  "diameter=\"%s\" of <tool>: the greatest diameter of its cutter is %.9g mm",
				  description_quote(file, described->at, "diameter").text, largest);
	return given;
}

/* False: reported; the tool cannot be added to the table. */
static bool check_tool(struct tool_builder *builder, const struct tool_description *described)
{
	struct description_file *file = builder->file;
	const struct tool *other;

	if (described->number > TOOL_NUMBER_MAX) {
		description_fault(file, described->at, "number", "number=\"%s\" of <tool> is not between 1 and %d",
				  description_quote(file, described->at, "number").text, TOOL_NUMBER_MAX);
		return false;
	}
	other = setup_tool(builder->setup, (int)described->number);
	if (other) {
		description_fault(file, described->at, "number", "tool %ld is given twice (also in line %ld)",
				  described->number, other->line);
		return false;
	}
	if (described->length > 0 && described->length <= TOOL_SIZE_MAX)
		return true;
	description_fault(file, described->at, "length", "length=\"%s\" of <tool> is not between 0 and %g mm",
			  description_quote(file, described->at, "length").text, TOOL_SIZE_MAX);
	return false;
}

void tool_build(struct tool_builder *builder, const struct tool_description *described)
{
	struct setup *setup = builder->setup;
	size_t faults = builder->file->faults;
	struct piece pieces[TOOL_PIECES] = {{0}};
	bool any = false;
	struct tool tool;

	if (!check_tool(builder, described))
		return;
	tool = (struct tool){
		.number = (int)described->number,
		.name = described->name ? described->name : "",
		.checked = described->checked,
		.length = described->length,
		.length_offset = described->length_offset.given ? described->length_offset.value : described->length,
		.kind = described->kind,
		.hand = described->hand,
		.line = description_place(builder->file, described->at).line,
	};
	for (int i = 0; i < TOOL_PIECES; i++) {
		pieces[i] = (struct piece){
		    .described = &described->pieces[i], .name = piece_names[i], .cutter = i == PIECE_CUTTER};
		build_piece(builder, &pieces[i]);
		any = any || described->pieces[i].at;
	}
	tool.diameter = build_tool_diameter(builder->file, described, &pieces[PIECE_CUTTER]);
	/* A radius of 0 or less: programs cannot compensate with this tool. */
	if (described->radius_offset.given)
		tool.diameter = fmax(0, 2 * described->radius_offset.value);
	tool.deltas = described->deltas;
	if (pieces[PIECE_CUTTER].solid.tip == TIP_CONE)
		tool.point_angle = pieces[PIECE_CUTTER].solid.angle;
	if (!any)
		diag_warning(builder->diag, description_place(builder->file, described->at),
			     "tool %d has no holder, shank or cutter, so nothing of it is checked", tool.number);
	else if (builder->file->faults == faults)
		stack(builder, described, pieces);
	setup->tools[setup->tool_count++] = tool;
	add_bodies(builder, &tool, pieces);
}
