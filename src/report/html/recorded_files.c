#include "report/html/recorded_files.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

/* The check uses one pointer for each file name; the program itself is identified by its name. */
size_t recorded_files_index(struct recorded_files *files, const char *name)
{
	for (size_t i = files->count; i-- > 0;) {
		if (files->items[i].interned == name)
			return i;
	}
	for (size_t i = 0; i < files->count; i++) {
		if (strcmp(files->items[i].name, name) != 0)
			continue;
		files->items[i].interned = name;
		return i;
	}
	files->items = mem_grow(files->items, &files->capacity, files->count + 1, sizeof(*files->items));
	files->items[files->count++] = (struct recorded_file){name, mem_strndup(name, strlen(name))};
	return files->count - 1;
}

void recorded_files_release(struct recorded_files *files)
{
	for (size_t i = 0; i < files->count; i++)
		free(files->items[i].name);
	free(files->items);
}
