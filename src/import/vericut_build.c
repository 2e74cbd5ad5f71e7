#include "import/vericut_build.h"

#include <string.h>

#include "base/ascii.h"
#include "machine/xml/foreign_xml.h"
#include "machine/xml/xml_element.h"

static bool is_type(const struct vericut_part *part, const char *type)
{
	return ascii_same(part->type, type);
}

bool vericut_part_is_axis(const struct vericut_part *part)
{
	return is_type(part, "linear") || is_type(part, "rotary");
}

static bool is_work(const struct vericut_part *part)
{
	return is_type(part, "stock") || is_type(part, "design");
}

bool vericut_part_is_model(const xmlNode *node)
{
	/* A model that was not recognised would be missing without notice. */
	static const char *const solids[] = {"Block", "Cylinder", "Cone", "Sphere", "Torus", "Revolve", "Sweep", NULL};

	for (const char *const *solid = solids; *solid; solid++)
		if (foreign_is(node, *solid))
			return true;
	return foreign_attribute(node, "Mirror") || foreign_child(node, "File") || foreign_child(node, "Position");
}

bool vericut_part_has_model(const struct vericut_part *part)
{
	for (const xmlNode *at = foreign_child(part->node, NULL); at; at = foreign_next(at, NULL))
		if (vericut_part_is_model(at))
			return true;
	return false;
}

static const struct vericut_part *find(const struct vericut_build *build, const char *name)
{
	for (size_t i = 0; i < build->count; i++)
		if (!strcmp(build->parts[i].name, name))
			return &build->parts[i];
	return NULL;
}

/* "": parts that carry each other in a cycle. */
static const char *carrier_of(const struct vericut_build *build, const struct vericut_part *part)
{
	for (size_t steps = 0; steps <= build->count; steps++) {
		if (!part->parent || vericut_part_is_axis(part->parent))
			return part->attach;
		part = part->parent;
	}
	return "";
}

static bool read_parts(struct vericut_build *build, const xmlNode *root, struct arena *arena)
{
	size_t count = 0;

	for (const xmlNode *node = foreign_child(root, "Component"); node; node = foreign_next(node, "Component"))
		count++;
	if (count > VERICUT_COMPONENTS_MAX) {
		xml_error(build->xml, root, NULL, "the setup has %zu components; at most %d can be read", count,
			  VERICUT_COMPONENTS_MAX);
		return false;
	}
	build->parts = arena_alloc(arena, count * sizeof(*build->parts));
	for (const xmlNode *node = foreign_child(root, "Component"); node; node = foreign_next(node, "Component")) {
		const char *name = foreign_attribute(node, "Name"), *type = foreign_attribute(node, "Type");

		if (!name || !*name || !type) {
			xml_error(build->xml, node, NULL, "a component needs a Name and a Type");
			return false;
		}
		build->parts[build->count++] = (struct vericut_part){
			.node = node,
			.name = arena_strdup(arena, name),
			.type = arena_strdup(arena, type),
			.attach = foreign_text(arena, foreign_child(node, "Attach")),
		};
	}
	for (size_t i = 0; i < build->count; i++)
		build->parts[i].parent = find(build, build->parts[i].attach);
	for (size_t i = 0; i < build->count; i++)
		build->parts[i].carrier = carrier_of(build, &build->parts[i]);
	return true;
}

/* --------------------------------------------------------------------- mount */

/* The first stock or design with a model; NULL: there is none. False, reported: others have another carrier. */
static bool find_work(const struct vericut_build *build, const struct vericut_part **first)
{
	*first = NULL;
	for (size_t i = 0; i < build->count; i++) {
		const struct vericut_part *part = &build->parts[i];

		if (!is_work(part) || !vericut_part_has_model(part))
			continue;
		if (*first && strcmp((*first)->carrier, part->carrier) != 0) {
			xml_error(build->xml, part->node, NULL,
				  "'%s' is on '%s', and '%s' on '%s', but a setup has its work in one place; save a "
				  "project for each",
				  xml_quote(part->name).text, xml_quote(part->carrier).text,
				  xml_quote((*first)->name).text, xml_quote((*first)->carrier).text);
			return false;
		}
		*first = *first ? *first : part;
	}
	return true;
}

/* The component to which the place in <To> belongs. */
static const char *place_of(const xmlNode *setup, const xmlNode *to, struct arena *arena)
{
	const char *name = foreign_text(arena, to);
	const xmlNode *system = foreign_child(foreign_child(setup, "CSystems"), "CSystem");

	if (!foreign_attribute_is(to, "CSystem", "on"))
		return name;
	while (system && !foreign_attribute_is(system, "Name", name))
		system = foreign_next(system, "CSystem");
	return foreign_text(arena, foreign_child(system, "Attach"));
}

/* The carrier of the first work offset on a component of the setup; NULL: there is none. */
static const char *mount_of_offsets(const struct vericut_build *build, const xmlNode *setup, struct arena *arena)
{
	const xmlNode *table = foreign_child(foreign_child(setup, "GCode"), "Table");

	for (; table; table = foreign_next(table, "Table"))
		for (const xmlNode *row = foreign_child(table, "Row"); row; row = foreign_next(row, "Row")) {
			const xmlNode *to = foreign_child(row, "To");
			const struct vericut_part *part = to ? find(build, place_of(setup, to, arena)) : NULL;

			if (part)
				return vericut_part_is_axis(part) ? part->name : part->carrier;
		}
	return NULL;
}

/* The carrier of the first stock, design or fixture, in this order of types; NULL: there is none. */
static const char *mount_of_types(const struct vericut_build *build)
{
	static const char *const types[] = {"stock", "design", "fixture"};

	for (size_t k = 0; k < sizeof(types) / sizeof(*types); k++)
		for (size_t i = 0; i < build->count; i++)
			if (is_type(&build->parts[i], types[k]))
				return build->parts[i].carrier;
	return build->count ? build->parts[0].carrier : NULL;
}

bool vericut_build_read(struct vericut_build *build, struct xml_reader *xml, const xmlNode *setup, struct arena *arena)
{
	const struct vericut_part *work;

	*build = (struct vericut_build){.xml = xml};
	if (!read_parts(build, foreign_child(setup, "Build"), arena) || !find_work(build, &work))
		return false;
	build->mount = work ? work->carrier : mount_of_offsets(build, setup, arena);
	if (!work && !build->mount)
		build->mount = mount_of_types(build);
	for (size_t i = 0; i < build->count; i++) {
		struct vericut_part *part = &build->parts[i];

		part->mounted = !vericut_part_is_axis(part) && !strcmp(part->carrier, build->mount);
		if (!work && is_work(part) && !part->mounted)
			build->other_mount = part->carrier;
	}
	return true;
}

/* ---------------------------------------------------------------- comparison */

static bool is_looks(const char *attribute)
{
	static const char *const looks[] = {"Visible", "Draw", "Hue", "Color"};

	for (size_t i = 0; i < sizeof(looks) / sizeof(*looks); i++)
		if (!strcmp(attribute, looks[i]))
			return true;
	return false;
}

/* Does `b` have the attributes of `a`? */
static bool has_attributes(const xmlNode *b, const xmlNode *a)
{
	for (const xmlAttr *at = a->properties; at; at = at->next) {
		const char *name = (const char *)at->name, *in_a = foreign_attribute(a, name);
		const char *in_b = foreign_attribute(b, name);

		if (!is_looks(name) && (!in_a || !in_b || strcmp(in_a, in_b) != 0))
			return false;
	}
	return true;
}

/* Are the elements equal except for their appearance? Elements with children have no text. */
static bool is_same_element(const xmlNode *a, const xmlNode *b, struct arena *arena)
{
	const xmlNode *in_a = foreign_child(a, NULL), *in_b = foreign_child(b, NULL);

	if (!foreign_is(a, (const char *)b->name) || !has_attributes(b, a) || !has_attributes(a, b))
		return false;
	if (!in_a && !in_b)
		return !strcmp(foreign_text(arena, a), foreign_text(arena, b));
	for (; in_a && in_b; in_a = foreign_next(in_a, NULL), in_b = foreign_next(in_b, NULL))
		if (!is_same_element(in_a, in_b, arena))
			return false;
	return !in_a && !in_b;
}

/* The first part of the machine in `a` that is missing in `b`; NULL: none is. */
static const struct vericut_part *find_difference(const struct vericut_build *a, const struct vericut_build *b,
						  struct arena *arena)
{
	for (size_t i = 0; i < a->count; i++) {
		const struct vericut_part *part = &a->parts[i], *other = find(b, part->name);

		if (!part->mounted && !(other && is_same_element(part->node, other->node, arena)))
			return part;
	}
	return NULL;
}

bool vericut_build_same(const struct vericut_build *build, const struct vericut_build *first)
{
	struct arena arena = {0};
	const struct vericut_part *different = NULL;

	if (!build->mount || !first->mount)
		return true;
	if (strcmp(build->mount, first->mount) != 0) {
		xml_error(build->xml, build->parts[0].node, NULL,
			  "the work of this setup is on '%s', that of the first setup on '%s': save a project for each",
			  xml_quote(build->mount).text, xml_quote(first->mount).text);
		return false;
	}
	different = find_difference(build, first, &arena);
	if (!different)
		different = find_difference(first, build, &arena);
	if (different)
		xml_error(build->xml, different->node, NULL,
			  "'%s' belongs to the machine, because it moves or is beside the work, and it is not the same "
			  "in all setups: save a project for each",
			  xml_quote(different->name).text);
	arena_release(&arena);
	return !different;
}
