#include "gcode/dialect/linuxcnc/params.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

static void named_clear(struct named_params *set)
{
	for (size_t i = 0; i < set->count; i++)
		free(set->items[i].name);
	set->count = 0;
}

static void named_release(struct named_params *set)
{
	named_clear(set);
	free(set->items);
	*set = (struct named_params){0};
}

void params_release(struct params *params)
{
	named_release(&params->global);
	for (int i = 0; i < PARAM_LEVELS; i++)
		named_release(&params->local[i]);
	free(params->pending);
}

static struct named_params *set_of(struct params *params, const char *name)
{
	return name[0] == '_' ? &params->global : &params->local[params->level];
}

/* The index of the name, or the index at which to insert it. */
static size_t search(const struct named_params *set, const char *name, bool *found)
{
	size_t low = 0, high = set->count;

	*found = false;
	while (low < high) {
		size_t middle = (low + high) / 2;
		int order = strcmp(set->items[middle].name, name);

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

struct named_param *params_find(struct params *params, const char *name)
{
	struct named_params *set = set_of(params, name);
	bool found;
	size_t i = search(set, name, &found);

	return found ? &set->items[i] : NULL;
}

struct named_param *params_make(struct params *params, const char *name)
{
	struct named_params *set = set_of(params, name);
	bool found;
	size_t i = search(set, name, &found);

	if (found)
		return &set->items[i];
	if (set->count >= PARAM_NAMES_MAX)
		return NULL;
	set->items = mem_grow(set->items, &set->capacity, set->count + 1, sizeof(*set->items));
	memmove(&set->items[i + 1], &set->items[i], (set->count - i) * sizeof(*set->items));
	set->count++;
	set->items[i] = (struct named_param){mem_strndup(name, strlen(name)), 0};
	return &set->items[i];
}

void params_enter(struct params *params)
{
	params->level++;
}

void params_leave(struct params *params)
{
	named_clear(&params->local[params->level]);
	params->level--;
}

struct assignment *params_assign(struct params *params)
{
	params->pending = mem_grow(params->pending, &params->pending_capacity, params->pending_count + 1,
				   sizeof(*params->pending));
	return &params->pending[params->pending_count++];
}
