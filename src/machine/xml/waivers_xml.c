#include "machine/waivers.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "base/units.h"
#include "machine/xml/xml_read.h"

/* What a report's four digits can be off by, and a little more. */
#define WITHIN 0.01
#define WITHIN_MAX 10.0

/* A blank reason is none. */
static const char *read_text(struct xml_reader *xml, const xmlNode *node, const char *name, struct arena *arena)
{
	const char *text = xml_attribute(node, name);

	if (text && text[strspn(text, " \t\r\n")])
		return arena_strdup(arena, text);
	if (text)
		xml_error(xml, node, "%s=\"\" of <waiver> is empty", name);
	return NULL;
}

/* One "X 10.0000 mm" at `at`; the end of it, or NULL. */
static const char *read_position(const char *at, int *slot, double *value)
{
	char number[32];
	size_t length;

	*slot = slot_of_letter(*at);
	if (*slot < 0)
		return NULL;
	at++;
	at += strspn(at, " ");
	length = strspn(at, "0123456789+-.");
	if (!length || length >= sizeof(number))
		return NULL;
	memcpy(number, at, length);
	number[length] = '\0';
	if (!xml_parse_number(number, value))
		return NULL;
	at += length;
	at += strspn(at, " ");
	if (!strncmp(at, slot_is_rotary(*slot) ? "deg" : "mm", slot_is_rotary(*slot) ? 3 : 2))
		at += slot_is_rotary(*slot) ? 3 : 2;
	return at + strspn(at, " ,");
}

/* "X 10.0000 mm, Z -100.0000 mm, C 0.0000 deg", as a report has it: every axis of the machine, once. */
static void read_axes(struct xml_reader *xml, const xmlNode *node, const struct machine *machine, axis_values *axes)
{
	const char *text = xml_attribute(node, "axes"), *at = text ? text + strspn(text, " ") : "";
	bool seen[SLOT_COUNT] = {false};

	while (*at) {
		double value;
		int slot;

		at = read_position(at, &slot, &value);
		if (!at || seen[slot] || !machine_axis(machine, slot)) {
			xml_error(xml, node, "axes=\"%s\" of <waiver> are no positions of this machine's axes such as "
					     "the reports have, \"X 10.0000 mm, C 90.0000 deg\"",
				  xml_quote(text).text);
			return;
		}
		seen[slot] = true;
		axes->v[slot] = slot_is_rotary(slot) ? radians(value) : value;
	}
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (machine_axis(machine, slot) && !seen[slot])
			xml_error(xml, node, "axes=\"%s\" of <waiver> lacks the axis %c", xml_quote(text).text,
				  AXIS_LETTERS[slot]);
	}
}

/* Two bodies, or the axis of a limit. */
static void read_subject(struct xml_reader *xml, const xmlNode *node, const struct machine *machine,
			 struct arena *arena, struct waiver *waiver)
{
	const char *axis = xml_attribute(node, "axis");
	bool limit = waiver->kind && !strcmp(waiver->kind, "limit");

	waiver->a = read_text(xml, node, "a", arena);
	waiver->b = read_text(xml, node, "b", arena);
	if (limit ? waiver->a || waiver->b || !axis : !waiver->a || !waiver->b || axis) {
		xml_error(xml, node, limit ? "<waiver kind=\"limit\"> needs axis=\"\", and has no bodies"
					   : "<waiver> needs the two bodies a=\"\" and b=\"\", and has no axis");
		return;
	}
	if (!limit)
		return;
	waiver->slot = strlen(axis) == 1 ? slot_of_letter(*axis) : -1;
	if (waiver->slot < 0 || !machine_axis(machine, waiver->slot))
		xml_error(xml, node, "axis=\"%s\" of <waiver>: the machine has no such axis", xml_quote(axis).text);
}

static void read_waiver(struct xml_reader *xml, const xmlNode *node, const struct machine *machine,
			struct arena *arena, struct waiver *waiver)
{
	const char *expires = xml_attribute(node, "expires");	/* the schema has seen that it is a date */

	waiver->line = xmlGetLineNo(node);
	waiver->program = read_text(xml, node, "program", arena);
	waiver->kind = read_text(xml, node, "kind", arena);
	waiver->reason = read_text(xml, node, "reason", arena);
	/* Of a program that ends without moving, the block has no text. */
	waiver->block = arena_strdup(arena, xml_attribute(node, "block"));
	waiver->within = xml_number(xml, node, "within", WITHIN);
	waiver->times = xml_integer(xml, node, "times", 1, 1, 1000000);
	if (!(waiver->within >= 0 && waiver->within <= WITHIN_MAX))
		xml_error(xml, node, "within=\"%s\" of <waiver> is not between 0 and %g",
			  xml_quote(xml_attribute(node, "within")).text, WITHIN_MAX);
	memcpy(waiver->expires, expires, DATE_SIZE);
	read_subject(xml, node, machine, arena, waiver);
	read_axes(xml, node, machine, &waiver->axes);
}

struct waivers *waivers_load(const char *path, const struct machine *machine, struct diag *diag)
{
	struct waivers *waivers;
	struct xml_reader xml;

	if (!xml_open(&xml, path, "waivers", diag))
		return NULL;
	waivers = mem_zalloc(1, sizeof(*waivers));
	waivers->path = arena_strdup(&waivers->arena, path);
	waivers->items = arena_alloc(&waivers->arena, xml_count(xml_root(&xml), "waiver") * sizeof(*waivers->items));
	for (const xmlNode *node = xml_first(xml_root(&xml)); node; node = xml_next(node))
		read_waiver(&xml, node, machine, &waivers->arena, &waivers->items[waivers->count++]);
	if (xml.errors) {
		waivers_free(waivers);
		waivers = NULL;
	}
	xml_close(&xml);
	return waivers;
}

void waivers_free(struct waivers *waivers)
{
	if (!waivers)
		return;
	arena_release(&waivers->arena);
	free(waivers);
}
