#include "machine/waivers.h"


#include "machine/waivers_build.h"
#include "machine/xml/xml_attribute.h"
#include "machine/xml/xml_element.h"

static const char *const elements[] = {"waivers", "waiver", NULL};

static const char *const kinds[] = {"collision", "clearance", "limit", "start-overlap", "rapid-contact", "gouge", NULL};

static const char *read_text(struct xml_reader *xml, const xmlNode *node, const char *name, struct arena *arena)
{
	const char *text = xml_attribute(xml, node, name);

	return text ? arena_strdup(arena, text) : NULL;
}

static const char *read_date(struct xml_reader *xml, const xmlNode *node, const char *name, struct arena *arena)
{
	const char *text = xml_attribute(xml, node, name);

	if (!text || waivers_is_date(text))
		return text ? arena_strdup(arena, text) : NULL;
	xml_error(xml, node, name, "%s=\"%s\" of <waiver> is not a date like 2026-12-31", name, xml_quote(text).text);
	return NULL;
}

static void read_waiver(struct xml_reader *xml, const xmlNode *node, void *context)
{
	struct waivers_description *described = context;
	struct waiver_description *waiver = &described->items[described->count++];
	struct arena *arena = &described->arena;

	xml_require(xml, node, "program", "kind", "block", "axes", "reason", "expires", NULL);
	waiver->at = node;
	waiver->program = read_text(xml, node, "program", arena);
	waiver->kind = kinds[xml_choice(xml, node, "kind", kinds, 0)];
	waiver->reason = read_text(xml, node, "reason", arena);
	waiver->block = read_text(xml, node, "block", arena);
	waiver->axes = read_text(xml, node, "axes", arena);
	waiver->axis = read_text(xml, node, "axis", arena);
	waiver->a = read_text(xml, node, "a", arena);
	waiver->b = read_text(xml, node, "b", arena);
	waiver->within = xml_optional_number(xml, node, "within");
	waiver->times = xml_whole(xml, node, "times", 1);
	waiver->expires = read_date(xml, node, "expires", arena);
	xml_read_nothing(xml, node);
}

struct waivers *waivers_load(const char *path, const struct machine *machine, struct diag *diag)
{
	static const struct xml_child children[] = {{"waiver", read_waiver, false, false}, {.name = NULL}};
	struct waivers_description described = {.count = 0};
	const char *machine_digest, *setup_digest;
	struct waivers *waivers = NULL;
	struct xml_reader xml;

	if (!xml_open(&xml, path, elements, diag))
		return NULL;
	described.file = xml_description_file(&xml);
	described.items =
	    arena_alloc(&described.arena, xml_count(xml_root(&xml), "waiver") * sizeof(*described.items));
	xml_require(&xml, xml_root(&xml), "version", NULL);
	machine_digest = xml_attribute(&xml, xml_root(&xml), "machine_sha256");
	setup_digest = xml_attribute(&xml, xml_root(&xml), "setup_sha256");
	xml_read_children(&xml, xml_root(&xml), children, &described);
	if (!xml.errors)
		waivers = waivers_build(&described, machine);
	if (waivers) {
		waivers->machine_sha256 = machine_digest ? arena_strdup(&waivers->arena, machine_digest) : NULL;
		waivers->setup_sha256 = setup_digest ? arena_strdup(&waivers->arena, setup_digest) : NULL;
		waivers->line = xmlGetLineNo(xml_root(&xml));
	}
	arena_release(&described.arena);
	xml_close(&xml);
	return waivers;
}
