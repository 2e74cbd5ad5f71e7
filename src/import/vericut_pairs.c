#include "import/vericut_pairs.h"

#include <string.h>

#include "base/ascii.h"

struct side {
	const struct vericut_component *component;
	bool with_all;	/* including the components that it carries */
};

struct pairing {
	struct import_machine *machine;
	const struct vericut_components *components;
	double clearance;
};

const char *const vericut_axis_names[SLOT_COUNT] = {"X", "Y", "Z", "A", "B", "C", "U", "V", "W"};

static bool is_type(const struct vericut_component *c, const char *type)
{
	return ascii_same(c->type, type);
}

static bool is_in(const struct vericut_component *c, const struct side *side)
{
	if (c == side->component)
		return true;
	for (c = c->parent; c && side->with_all; c = c->parent)
		if (c == side->component)
			return true;
	return false;
}

/* Calls `use` with each name that represents a part of the component. */
static void for_names(const struct pairing *p, const struct vericut_component *c,
		      void (*use)(const struct pairing *p, const char *name, const void *context), const void *context)
{
	static const char *const tool[] = {"holder", "shank", "cutter"};
	const struct machine_description *d = &p->machine->description;
	const bool has_work = p->machine->work_name && !strcmp(c->name, p->machine->work_name);

	if (is_type(c, "attach") || has_work)
		for (int i = 0; i < 2; i++)
			use(p, i ? "part" : "fixture", context);
	if (c->slot >= 0)
		use(p, vericut_axis_names[c->slot], context);
	else if (!c->parent)
		use(p, "base", context);
	else if (is_type(c, "tool"))
		for (size_t i = 0; i < sizeof(tool) / sizeof(*tool); i++)
			use(p, tool[i], context);
	else
		for (size_t i = 0; i < d->body_count; i++)
			if (d->bodies[i].at == c)
				use(p, d->bodies[i].name, context);
}

static void add_pair(const struct pairing *p, const char *name, const void *context)
{
	const char *other = context;

	if (strcmp(name, other) != 0)
		import_machine_add_pair(p->machine, other, name, p->clearance);
}

static void add_second_side(const struct pairing *p, const char *name, const void *context)
{
	const struct side *second = context;

	for (size_t i = 0; i < p->components->count; i++)
		if (is_in(&p->components->items[i], second))
			for_names(p, &p->components->items[i], add_pair, name);
}

static bool read_side(struct xml_reader *xml, const xmlNode *between, const xmlNode *name, const char *sub,
		      const struct vericut_components *components, struct side *side, struct arena *arena)
{
	const char *text = foreign_text(arena, name);

	side->component = vericut_components_find(components, text);
	side->with_all = foreign_attribute_is(between, sub, "on");
	if (!side->component)
		xml_error(xml, between, NULL, "the collision list names '%s', which is not a component of this machine",
			  xml_quote(text).text);
	return side->component;
}

static bool read_between(struct pairing *p, struct xml_reader *xml, const xmlNode *between)
{
	const xmlNode *one = foreign_child(between, "Component"), *two = one ? foreign_next(one, "Component") : NULL;
	struct arena *arena = &p->machine->description.arena;
	struct side first, second;

	if (!two) {
		xml_error(xml, between, NULL, "<Between> needs two components");
		return false;
	}
	if (!read_side(xml, between, one, "Sub1", p->components, &first, arena) ||
	    !read_side(xml, between, two, "Sub2", p->components, &second, arena) ||
	    !foreign_number(xml, between, "Tol", &p->clearance))
		return false;
	p->clearance *= xml->unit;
	if (p->clearance < 0) {
		xml_error(xml, between, "Tol", "the tolerance of a pair must not be negative");
		return false;
	}
	for (size_t i = 0; i < p->components->count; i++)
		if (is_in(&p->components->items[i], &first))
			for_names(p, &p->components->items[i], add_second_side, &second);
	return true;
}

bool vericut_pairs_read(struct import_machine *machine, const struct vericut_components *components,
			struct xml_reader *xml)
{
	const xmlNode *list = foreign_child(xmlDocGetRootElement(xml->doc), "Collision");
	const xmlNode *between = list ? foreign_child(list, "Between") : NULL;
	struct pairing p = {.machine = machine, .components = components};

	for (; between; between = foreign_next(between, "Between"))
		if (!read_between(&p, xml, between))
			return false;
	return true;
}
