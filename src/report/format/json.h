/* json.h - builds JSON for the reports: strings are valid UTF-8, numbers have a fixed precision. */
#ifndef FIVECHECK_REPORT_FORMAT_JSON_H
#define FIVECHECK_REPORT_FORMAT_JSON_H

#include <jansson.h>
#include <stdbool.h>

#include "base/axes.h"
#include "base/strbuf.h"
#include "geom/vec3.h"
#include "machine/machine.h"

/* Makes the JSON library use mem_alloc. Call it once, before any other function of the library. */
void json_init(void);

/* Sets a key to a value and takes ownership of the value. */
void json_put(json_t *object, const char *key, json_t *value);

/* Appends to an array and takes ownership of the value. */
void json_push(json_t *array, json_t *value);

/* A string, or null for NULL. Bytes that are not UTF-8 become U+FFFD. */
json_t *json_text(const char *text);

/* {"part":2,"parts":5,"of":"blocks"}, or "of":"programs"; null if shards is 0. */
json_t *json_shard(int shard, int shards, bool of_blocks);

/* Axes by name in the order X Y Z A B C U V W, in mm and degrees. */
json_t *json_axes(const struct machine *machine, const axis_values *axes);

/* [x, y, z] */
json_t *json_point(vec3 p);

/* Appends the value as one line, numbers with 12 digits, and releases it. */
void json_add_line(struct strbuf *out, json_t *value);

#endif
