#include "base/file_names.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

const char *file_names_keep(struct file_names *names, const char *name)
{
	for (size_t i = 0; i < names->count; i++)
		if (!strcmp(names->items[i], name))
			return names->items[i];
	names->items = mem_grow(names->items, &names->capacity, names->count + 1, sizeof(*names->items));
	names->items[names->count] = mem_strndup(name, strlen(name));
	return names->items[names->count++];
}

void file_names_release(struct file_names *names)
{
	for (size_t i = 0; i < names->count; i++)
		free(names->items[i]);
	free(names->items);
	*names = (struct file_names){0};
}
