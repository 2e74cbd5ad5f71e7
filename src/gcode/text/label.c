#include "gcode/text/label.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

void labels_release(struct labels *labels)
{
	for (size_t i = 0; i < labels->count; i++) {
		free(labels->items[i]->key);
		free(labels->items[i]);
	}
	free(labels->items);
	*labels = (struct labels){0};
}

/* The index of the key, or the index at which to insert it. */
static size_t search(const struct labels *labels, const char *key, bool *found)
{
	size_t low = 0, high = labels->count;

	*found = false;
	while (low < high) {
		size_t middle = (low + high) / 2;
		int order = strcmp(labels->items[middle]->key, key);

		if (order == 0) {
			*found = true;
			return middle;
		}
		if (order < 0)
			low = middle + 1;
		else
			high = middle;
	}
	return low;
}

struct label *labels_find(const struct labels *labels, const char *key)
{
	bool found;
	size_t i = search(labels, key, &found);

	return found ? labels->items[i] : NULL;
}

struct label *labels_add(struct labels *labels, const char *key, int kind)
{
	struct label *label;
	bool found;
	size_t i = search(labels, key, &found);

	if (labels->count >= LABELS_MAX)
		return NULL;
	labels->items = mem_grow(labels->items, &labels->capacity, labels->count + 1, sizeof(struct label *));
	memmove(&labels->items[i + 1], &labels->items[i], (labels->count - i) * sizeof(struct label *));
	labels->count++;
	label = mem_zalloc(1, sizeof(*label));
	label->key = mem_strndup(key, strlen(key));
	label->kind = kind;
	labels->items[i] = label;
	return label;
}
