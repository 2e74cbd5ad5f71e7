#include "report/format/json.h"

#include <assert.h>
#include <stdlib.h>

#include "base/mem.h"
#include "base/utf8.h"
#include "report/format/format_units.h"

void json_init(void)
{
	json_set_alloc_funcs(mem_alloc, free);
}

/* json_init makes running out of memory fatal, so this fails only if the value is a number that is not finite. */
void json_put(json_t *object, const char *key, json_t *value)
{
	int failed = json_object_set_new(object, key, value);

	assert(!failed);
	(void)failed;
}

void json_push(json_t *array, json_t *value)
{
	int failed = json_array_append_new(array, value);

	assert(!failed);
	(void)failed;
}

json_t *json_text(const char *text)
{
	struct strbuf clean = {0};
	json_t *string;

	if (!text)
		return json_null();
	utf8_add_clean(&clean, text);
	string = json_string(strbuf_text(&clean));
	strbuf_release(&clean);
	return string;
}

json_t *json_shard(int shard, int shards, bool of_blocks)
{
	json_t *object;

	if (!shards)
		return json_null();
	object = json_object();
	json_put(object, "part", json_integer(shard));
	json_put(object, "parts", json_integer(shards));
	json_put(object, "of", json_string(of_blocks ? "blocks" : "programs"));
	return object;
}

json_t *json_axes(const struct machine *machine, const axis_values *axes)
{
	json_t *object = json_object();

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		const char name[2] = {AXIS_LETTERS[slot], '\0'};

		if (machine_axis(machine, slot))
			json_put(object, name, json_real(format_units_value(slot, axes->v[slot])));
	}
	return object;
}

json_t *json_point(vec3 p)
{
	json_t *array = json_array();

	json_push(array, json_real(p.x + 0.0));
	json_push(array, json_real(p.y + 0.0));
	json_push(array, json_real(p.z + 0.0));
	return array;
}

void json_add_line(struct strbuf *out, json_t *value)
{
	char *line = json_dumps(value, JSON_COMPACT | JSON_REAL_PRECISION(12));

	strbuf_addf(out, "%s\n", line);
	free(line);
	json_decref(value);
}
