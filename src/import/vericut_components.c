#include "import/vericut_components.h"

#include "base/ascii.h"
#include "base/math/math_functions.h"

#include <string.h>

struct vericut_component *vericut_components_find(const struct vericut_components *components, const char *name)
{
	for (size_t i = 0; i < components->count; i++)
		if (!strcmp(components->items[i].name, name))
			return &components->items[i];
	return NULL;
}

bool vericut_frame(struct xml_reader *xml, const xmlNode *node, xform *frame)
{
	const xmlNode *position = foreign_child(node, "Position"), *rotation = foreign_child(node, "Rotation");
	const double degree = math_acos(-1) / 180;
	vec3 p = {0, 0, 0}, r = {0, 0, 0};
	mat3 about_x, about_y, about_z;

	if ((position && !foreign_vector(xml, position, "X", "Y", "Z", &p)) ||
	    (rotation && !foreign_vector(xml, rotation, "I", "J", "K", &r)))
		return false;
	about_x = mat3_turn((vec3){1, 0, 0}, degree * r.x);
	about_y = mat3_turn((vec3){0, 1, 0}, degree * r.y);
	about_z = mat3_turn((vec3){0, 0, 1}, degree * r.z);
	about_y = mat3_mul(&about_y, &about_x);
	*frame = (xform){mat3_mul(&about_z, &about_y), vec3_scale(xml->unit, p)};
	return true;
}

static bool read_component(struct vericut_components *components, struct xml_reader *xml, const xmlNode *node,
			   struct arena *arena)
{
	struct vericut_component *c = &components->items[components->count];
	const char *name = foreign_attribute(node, "Name"), *type = foreign_attribute(node, "Type");

	if (!name || !*name || !type) {
		xml_error(xml, node, NULL, "a component needs a Name and a Type");
		return false;
	}
	if (vericut_components_find(components, name)) {
		xml_error(xml, node, "Name", "there is a second component '%s'", xml_quote(name).text);
		return false;
	}
	*c = (struct vericut_component){
		.node = node,
		.xml = xml,
		.name = name,
		.type = type,
		.attach = foreign_text(arena, foreign_child(node, "Attach")),
		.slot = -1,
	};
	components->count++;
	return true;
}

/* Places the components attached to placed ones. Returns the new number of placed ones. */
static size_t place_more(struct vericut_components *components, size_t placed)
{
	size_t before = placed;

	for (size_t i = 0; i < components->count; i++) {
		struct vericut_component *c = &components->items[i];
		xform local;

		if (c->placed || (c->parent && !c->parent->placed))
			continue;
		if (!vericut_frame(c->xml, c->node, &local))
			return 0;
		c->frame = c->parent ? xform_mul(&c->parent->frame, &local) : local;
		c->placed = true;
		components->order[placed++] = c;
	}
	return placed - before;
}

static bool place_all(struct vericut_components *components)
{
	size_t placed = 0, more;

	do {
		more = place_more(components, placed);
		placed += more;
	} while (more && placed < components->count);
	for (size_t i = 0; i < components->count; i++)
		if (components->items[i].xml->errors)
			return false;
	for (size_t i = 0; i < components->count; i++) {
		const struct vericut_component *c = &components->items[i];

		if (c->placed)
			continue;
		xml_error(c->xml, c->node, "Name", "the component '%s' carries itself", xml_quote(c->name).text);
		return false;
	}
	return true;
}

/* False, reported: a component of the machine is attached to an unknown one, or there are two bases. */
static bool find_parents(struct vericut_components *components)
{
	const struct vericut_component *base = NULL;

	for (size_t i = 0; i < components->count; i++) {
		struct vericut_component *c = &components->items[i];

		c->parent = *c->attach ? vericut_components_find(components, c->attach) : NULL;
		if (!c->parent && (*c->attach || c->of_setup))
			xml_error(c->xml, *c->attach ? foreign_child(c->node, "Attach") : c->node, NULL,
				  "'%s' is attached to '%s', which is not a component of %s",
				  xml_quote(c->name).text, xml_quote(c->attach).text,
				  c->of_setup ? "this setup or its machine" : "this machine");
		else if (!c->parent && base)
			xml_error(c->xml, c->node, NULL,
				  "'%s' and '%s' are both attached to nothing: a machine has one base",
				  xml_quote(base->name).text, xml_quote(c->name).text);
		else
			base = c->parent ? base : c;
		if (c->xml->errors)
			return false;
	}
	return true;
}

static void mark_carriers(const struct vericut_components *components)
{
	static const char *const work[] = {"attach", "stock", "fixture", "design"};

	for (size_t i = 0; i < components->count; i++) {
		bool holds = false;

		for (size_t k = 0; k < sizeof(work) / sizeof(*work); k++)
			holds |= ascii_same(components->items[i].type, work[k]);
		for (struct vericut_component *c = holds ? &components->items[i] : NULL; c; c = c->parent)
			c->carries_work = true;
	}
}

static void make_room(struct vericut_components *components, size_t count, struct arena *arena)
{
	*components = (struct vericut_components){
		.items = arena_alloc(arena, count * sizeof(*components->items)),
		.order = arena_alloc(arena, count * sizeof(struct vericut_component *)),
	};
}

/* Adds the components of a setup that are mounted, or all of them. */
static bool add_parts(struct vericut_components *components, const struct vericut_build *build, bool all,
		      struct arena *arena)
{
	for (size_t i = 0; i < build->count; i++) {
		const struct vericut_part *part = &build->parts[i];
		struct vericut_component *c = &components->items[components->count];

		if (!all && !part->mounted)
			continue;
		if (!read_component(components, build->xml, part->node, arena))
			return false;
		c->of_setup = true;
		c->mounted = part->mounted;
	}
	return true;
}

bool vericut_components_read(struct vericut_components *components, struct xml_reader *xml, const xmlNode *root,
			     const struct vericut_build *build, struct arena *arena)
{
	size_t count = 0;

	for (const xmlNode *node = foreign_child(root, "Component"); node; node = foreign_next(node, "Component"))
		count++;
	if (count == 0 || count > VERICUT_COMPONENTS_MAX) {
		xml_error(xml, root, NULL, "the machine has %zu components; 1 to %d can be read", count,
			  VERICUT_COMPONENTS_MAX);
		return false;
	}
	make_room(components, count + (build ? build->count : 0), arena);
	for (const xmlNode *node = foreign_child(root, "Component"); node; node = foreign_next(node, "Component"))
		if (!read_component(components, xml, node, arena))
			return false;
	if ((build && !add_parts(components, build, true, arena)) || !find_parents(components) ||
	    !place_all(components))
		return false;
	mark_carriers(components);
	return true;
}

/* A component attached to the mount has no parent; all others have one, because the mount is their carrier. */
bool vericut_components_mounted(struct vericut_components *components, const struct vericut_build *build,
				struct arena *arena)
{
	make_room(components, build->count, arena);
	if (!add_parts(components, build, false, arena))
		return false;
	for (size_t i = 0; i < components->count; i++)
		components->items[i].parent = vericut_components_find(components, components->items[i].attach);
	return place_all(components);
}
