#include "report/ndjson.h"

#include <assert.h>
#include <jansson.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "report/quantity.h"

/* How many bytes the UTF-8 sequence at text takes (RFC 3629), 0 if it is none. */
static size_t utf8_length(const unsigned char *text)
{
	unsigned char c = text[0];
	size_t length = c < 0x80 ? 1 : c < 0xc2 ? 0 : c < 0xe0 ? 2 : c < 0xf0 ? 3 : c < 0xf5 ? 4 : 0;

	for (size_t i = 1; i < length; i++) {
		if ((text[i] & 0xc0) != 0x80)
			return 0;
	}
	/* Overlong forms, surrogates, and what is beyond U+10FFFF. */
	if ((c == 0xe0 && text[1] < 0xa0) || (c == 0xed && text[1] > 0x9f) || (c == 0xf0 && text[1] < 0x90) ||
	    (c == 0xf4 && text[1] > 0x8f))
		return 0;
	return length;
}

/* Memory cannot run out (ndjson_init): what fails here is a number that is none. */
static void set(json_t *object, const char *key, json_t *value)
{
	int failed = json_object_set_new(object, key, value);

	assert(!failed);
	(void)failed;
}

static json_t *string_of(const char *text)
{
	struct strbuf clean = {0};
	json_t *string;

	if (!text)
		return json_null();
	while (*text) {
		size_t length = utf8_length((const unsigned char *)text);

		if (length)
			strbuf_add(&clean, text, length);
		else
			strbuf_addf(&clean, "\xef\xbf\xbd");
		text += length ? length : 1;
	}
	string = json_string(strbuf_text(&clean));
	strbuf_release(&clean);
	return string;
}

static json_t *axes_of(const struct machine *machine, const axis_values *axes)
{
	json_t *object = json_object();

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		const char name[2] = {AXIS_LETTERS[slot], '\0'};

		if (machine_axis(machine, slot))
			set(object, name, json_real(quantity_value(slot, axes->v[slot])));
	}
	return object;
}

static json_t *point_of(vec3 p)
{
	json_t *array = json_array();

	json_array_append_new(array, json_real(p.x + 0.0));
	json_array_append_new(array, json_real(p.y + 0.0));
	json_array_append_new(array, json_real(p.z + 0.0));
	return array;
}

void ndjson_init(void)
{
	json_set_alloc_funcs(mem_alloc, free);
}

void ndjson_finding(struct strbuf *out, const struct machine *machine, const struct finding *f)
{
	bool bodies = f->kind != FINDING_LIMIT;
	json_t *object = json_object();
	char *line;

	set(object, "kind", json_string(finding_kind_name(f->kind)));
	set(object, "file", string_of(f->file));
	set(object, "line", json_integer(f->line));
	set(object, "column", json_integer(f->column));
	set(object, "move", json_integer(f->move));
	set(object, "fraction", json_real(f->fraction));
	set(object, "a", string_of(bodies ? f->a : NULL));
	set(object, "b", string_of(bodies ? f->b : NULL));
	set(object, "axes", axes_of(machine, &f->axes));
	set(object, "time", json_real(f->time));
	set(object, "point", bodies ? point_of(f->point) : json_null());
	set(object, "clearance", bodies ? json_real(f->clearance) : json_null());
	if (!bodies) {
		const char axis[2] = {AXIS_LETTERS[f->slot], '\0'};

		set(object, "axis", json_string(axis));
		set(object, "bound", json_real(quantity_value(f->slot, f->bound)));
	}
	line = json_dumps(object, JSON_COMPACT | JSON_REAL_PRECISION(12));
	strbuf_addf(out, "%s\n", line);
	free(line);
	json_decref(object);
}
