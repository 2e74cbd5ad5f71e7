/* json.h - the JSON of the reports: texts that are always valid, numbers with the same digits, one line an object. */
#ifndef FIVECHECK_REPORT_FORMAT_JSON_H
#define FIVECHECK_REPORT_FORMAT_JSON_H

#include <jansson.h>
#include <stdbool.h>

#include "base/axes.h"
#include "base/strbuf.h"
#include "geom/vec3.h"
#include "machine/machine.h"

/* Lets the JSON library take its memory where everybody does. Once, before anything else. */
void json_init(void);

/* Sets a key to a value and takes the value over. */
void json_put(json_t *object, const char *key, json_t *value);

/* Appends to an array and takes the value over. */
void json_push(json_t *array, json_t *value);

/* A string; bytes that are no UTF-8 become U+FFFD. null for NULL. */
json_t *json_text(const char *text);

/* {"part":2,"parts":5,"of":"blocks"}, or of "programs"; null for 0 of 0. */
json_t *json_share(int shard, int shards, bool of_blocks);

/* Axes by name in the order X Y Z A B C U V W, in mm and degrees. */
json_t *json_axes(const struct machine *machine, const axis_values *axes);

/* [x, y, z] */
json_t *json_point(vec3 p);

/* Appends the value as one line, numbers with 12 digits, and releases it. */
void json_add_line(struct strbuf *out, json_t *value);

#endif
