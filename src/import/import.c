#include "import/import.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/mem.h"
#include "base/strbuf.h"
#include "machine/body.h"

/* A longer name is shortened: it would only make messages hard to read. */
#define NAME_MAX_BYTES 60

void import_machine_release(struct import_machine *machine)
{
	for (size_t i = 0; i < machine->description.body_count; i++)
		mesh_release(&machine->meshes[i]);
	free(machine->meshes);
	free(machine->description.bodies);
	free(machine->description.pairs);
	arena_release(&machine->description.arena);
	*machine = (struct import_machine){0};
}

void import_machine_todo(struct import_machine *machine, const char *format, ...)
{
	struct strbuf text = {0};
	va_list args;

	if (machine->todo_count == IMPORT_TODO_MAX)
		return;
	va_start(args, format);
	strbuf_addv(&text, format, args);
	va_end(args);
	machine->todo[machine->todo_count++] = arena_strdup(&machine->description.arena, strbuf_text(&text));
	strbuf_release(&text);
}

/* ------------------------------------------------------------------- names */

/* Names of bodies become file names, and some file systems do not distinguish upper and lower case. */
static bool is_taken(const struct import_machine *machine, const char *name)
{
	for (; machine; machine = machine->beside)
		for (size_t i = 0; i < machine->description.body_count; i++)
			if (ascii_same(machine->description.bodies[i].name, name))
				return true;
	return false;
}

/* Appends letters, digits and the characters that join them; every other run of characters becomes one '_'. */
static void add_plain(struct strbuf *out, const char *text)
{
	bool joined = false;

	for (; *text && out->length < NAME_MAX_BYTES; text++) {
		bool plain = ascii_is_alphanumeric(*text) || (*text && strchr("-.+", *text));

		if (plain && (out->length || *text != '.')) {
			strbuf_add(out, text, 1);
			joined = false;
		} else if (!joined && out->length) {
			strbuf_add(out, "_", 1);
			joined = true;
		}
	}
	while (out->length && out->text[out->length - 1] == '_')
		out->text[--out->length] = '\0';
}

static const char *make_name(struct import_machine *machine, const char *wanted, const char *otherwise)
{
	struct strbuf name = {0};
	const char *kept;

	add_plain(&name, wanted);
	if (!name.length || body_name_is_reserved(strbuf_text(&name)) || is_taken(machine, strbuf_text(&name))) {
		strbuf_clear(&name);
		add_plain(&name, otherwise);
		strbuf_add(&name, "_", name.length > 0);
		add_plain(&name, wanted);
		if (!name.length)
			strbuf_addf(&name, "body");
	}
	for (size_t stem = name.length, number = 2;
	     body_name_is_reserved(strbuf_text(&name)) || is_taken(machine, strbuf_text(&name)); number++) {
		name.length = stem;
		strbuf_addf(&name, "_%zu", number);
	}
	kept = arena_strdup(&machine->description.arena, strbuf_text(&name));
	strbuf_release(&name);
	return kept;
}

/* ------------------------------------------------------------------ bodies */

struct body_description *import_machine_add_body(struct import_machine *machine, const char *wanted,
						 const char *otherwise, int link, const xform *frame,
						 struct mesh *mesh)
{
	struct machine_description *d = &machine->description;
	const char *name = make_name(machine, wanted, otherwise);
	struct strbuf path = {0};

	d->bodies = mem_grow(d->bodies, &machine->body_capacity, d->body_count + 1, sizeof(*d->bodies));
	machine->meshes =
		mem_grow(machine->meshes, &machine->mesh_capacity, d->body_count + 1, sizeof(*machine->meshes));
	strbuf_addf(&path, "%s/%s.stl", machine->folder ? machine->folder : "stl", name);
	d->bodies[d->body_count] = (struct body_description){
		.name = name,
		.mesh_path = arena_strdup(&d->arena, strbuf_text(&path)),
		.scale = 1,
		.frame = *frame,
		.link = link,
	};
	machine->meshes[d->body_count] = *mesh;
	*mesh = (struct mesh){0};
	strbuf_release(&path);
	return &d->bodies[d->body_count++];
}

/* ------------------------------------------------------------------- pairs */

static bool names_both(const struct pair_description *pair, const char *a, const char *b)
{
	return (!strcmp(pair->a, a) && !strcmp(pair->b, b)) || (!strcmp(pair->a, b) && !strcmp(pair->b, a));
}

void import_machine_add_pair(struct import_machine *machine, const char *a, const char *b, double clearance)
{
	struct machine_description *d = &machine->description;

	for (size_t i = 0; i < d->pair_count; i++) {
		struct pair_description *pair = &d->pairs[i];

		if (!names_both(pair, a, b))
			continue;
		if (clearance > pair->clearance.value)
			pair->clearance.value = clearance;
		return;
	}
	d->pairs = mem_grow(d->pairs, &machine->pair_capacity, d->pair_count + 1, sizeof(*d->pairs));
	d->pairs[d->pair_count++] = (struct pair_description){
		.a = arena_strdup(&d->arena, a),
		.b = arena_strdup(&d->arena, b),
		.check = PAIR_ALWAYS,
		.clearance = {.given = true, .value = clearance},
	};
}
