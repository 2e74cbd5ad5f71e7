#include "machine/waivers.h"

#include <stdlib.h>
#include <string.h>

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

/* "2026-12-31", and the month has that day: less than XML Schema's dates, which may have a zone and odd years. */
static bool is_date(const char *text)
{
	static const int lengths[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
	static const char form[] = "dddd-dd-dd";
	long year, month, day;

	if (strlen(text) != DATE_SIZE - 1)
		return false;
	for (int i = 0; form[i]; i++)
		if (form[i] == 'd' ? text[i] < '0' || text[i] > '9' : text[i] != form[i])
			return false;
	year = strtol(text, NULL, 10);
	month = strtol(text + 5, NULL, 10);
	day = strtol(text + 8, NULL, 10);
	if (month < 1 || month > 12 || day < 1 || year < 1)
		return false;
	return day <= lengths[month - 1] + (month == 2 && (year % 400 == 0 || (year % 4 == 0 && year % 100 != 0)));
}

static const char *read_date(struct xml_reader *xml, const xmlNode *node, const char *name, struct arena *arena)
{
	const char *text = xml_attribute(xml, node, name);

	if (!text || is_date(text))
		return text ? arena_strdup(arena, text) : NULL;
	xml_error(xml, node, name, "%s=\"%s\" of <waiver> is no date like 2026-12-31", name, xml_quote(text).text);
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
	struct waivers *waivers = NULL;
	struct xml_reader xml;

	if (!xml_open(&xml, path, elements, diag))
		return NULL;
	described.file = xml_description_file(&xml);
	described.items =
	    arena_alloc(&described.arena, xml_count(xml_root(&xml), "waiver") * sizeof(*described.items));
	xml_require(&xml, xml_root(&xml), "version", NULL);
	xml_read_children(&xml, xml_root(&xml), children, &described);
	if (!xml.errors)
		waivers = waivers_build(&described, machine);
	arena_release(&described.arena);
	xml_close(&xml);
	return waivers;
}
