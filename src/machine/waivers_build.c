#include "machine/waivers_build.h"

#include <stdlib.h>
#include <string.h>

#include "base/decimal.h"
#include "base/mem.h"
#include "base/units.h"

/* mm and degrees: the rounding of a report's four digits, and a little more. */
#define WITHIN 0.01
#define WITHIN_MAX 10.0
#define TIMES_MAX 1000000

/* Reads one "X 10.0000 mm" at `at`; returns its end, or NULL. */
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
	if (!decimal_read(number, length, value))
		return NULL;
	at += length;
	at += strspn(at, " ");
	if (!strncmp(at, slot_is_rotary(*slot) ? "deg" : "mm", slot_is_rotary(*slot) ? 3 : 2))
		at += slot_is_rotary(*slot) ? 3 : 2;
	return at + strspn(at, " ,");
}

/* Reads "X 10.0000 mm, Z -100.0000 mm, C 0.0000 deg", as reports print it: every axis of the machine, once. */
static void build_axes(struct description_file *file, const struct waiver_description *described,
		       const struct machine *machine, axis_values *axes)
{
	const char *at = described->axes + strspn(described->axes, " ");
	bool seen[SLOT_COUNT] = {false};

	while (*at) {
		double value;
		int slot;

		at = read_position(at, &slot, &value);
		if (!at || seen[slot] || !machine_axis(machine, slot)) {
			description_fault(file, described->at, "axes",
					  "axes=\"%s\" of <waiver> must be positions of this machine's axes as reports "
					  "print them, \"X 10.0000 mm, C 90.0000 deg\"",
					  description_quote(file, described->at, "axes").text);
			return;
		}
		seen[slot] = true;
		axes->v[slot] = slot_is_rotary(slot) ? radians(value) : value;
	}
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (machine_axis(machine, slot) && !seen[slot])
			description_fault(file, described->at, "axes",
					  "axes=\"%s\" of <waiver> has no position of axis %c",
					  description_quote(file, described->at, "axes").text, AXIS_LETTERS[slot]);
	}
}

/* Two bodies, or the axis of a limit. */
static void build_subject(struct description_file *file, const struct waiver_description *described,
			  const struct machine *machine, struct waiver *waiver)
{
	const char *axis = described->axis;
	bool limit = !strcmp(described->kind, "limit");

	if (limit ? waiver->a || waiver->b || !axis : !waiver->a || !waiver->b || axis) {
		description_fault(file, described->at, NULL,
				  limit ? "<waiver kind=\"limit\"> needs axis=\"\", and cannot have bodies"
					: "<waiver> needs the two bodies a=\"\" and b=\"\", and cannot have an axis");
		return;
	}
	if (!limit)
		return;
	waiver->slot = strlen(axis) == 1 ? slot_of_letter(*axis) : -1;
	if (waiver->slot < 0 || !machine_axis(machine, waiver->slot))
		description_fault(file, described->at, "axis", "axis=\"%s\" of <waiver>: the machine has no such axis",
				  description_quote(file, described->at, "axis").text);
}

/* A blank text counts as missing. */
static const char *build_text(struct description_file *file, const void *at, const char *name, const char *text)
{
	if (!text || text[strspn(text, " \t\r\n")])
		return text;
	description_fault(file, at, name, "%s=\"\" of <waiver> is empty", name);
	return NULL;
}

static void build_waiver(struct description_file *file, const struct waiver_description *described,
			 const struct machine *machine, struct waiver *waiver)
{
	*waiver = (struct waiver){
		.program = build_text(file, described->at, "program", described->program),
		.kind = described->kind,
		.a = build_text(file, described->at, "a", described->a),
		.b = build_text(file, described->at, "b", described->b),
		.block = described->block,	/* empty if the program ends without a motion */
		.within = described->within.given ? described->within.value : WITHIN,
		.times = (int)described->times,
		.reason = build_text(file, described->at, "reason", described->reason),
		.line = description_place(file, described->at).line,
	};
	memcpy(waiver->expires, described->expires, DATE_SIZE);
	if (described->times < 1 || described->times > TIMES_MAX)
		description_fault(file, described->at, "times", "times=\"%s\" of <waiver> is not between 1 and %d",
				  description_quote(file, described->at, "times").text, TIMES_MAX);
	if (!(waiver->within >= 0 && waiver->within <= WITHIN_MAX))
		description_fault(file, described->at, "within", "within=\"%s\" of <waiver> is not between 0 and %g",
				  description_quote(file, described->at, "within").text, WITHIN_MAX);
	build_subject(file, described, machine, waiver);
	build_axes(file, described, machine, &waiver->axes);
}

struct waivers *waivers_build(struct waivers_description *described, const struct machine *machine)
{
	struct waivers *waivers = mem_zalloc(1, sizeof(*waivers));

	waivers->arena = described->arena;
	described->arena = (struct arena){0};
	waivers->path = arena_strdup(&waivers->arena, described->file.path);
	waivers->items = arena_alloc(&waivers->arena, described->count * sizeof(*waivers->items));
	for (size_t i = 0; i < described->count; i++)
		build_waiver(&described->file, &described->items[i], machine, &waivers->items[waivers->count++]);
	if (described->file.faults == 0)
		return waivers;
	waivers_free(waivers);
	return NULL;
}
