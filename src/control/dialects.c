#include "control/dialects.h"

#include <stddef.h>
#include <string.h>

#define FULL_ROW(id, shown, ...) {.name = #id, .title = shown, __VA_ARGS__},
#define NAME_ROW(id, ...) #id,

const struct dialect_row dialect_rows[] = {DIALECTS(FULL_ROW)};

const char *const dialect_names[] = {DIALECTS(NAME_ROW) NULL};

int dialect_row_find(const char *name)
{
	for (int i = 0; dialect_names[i]; i++) {
		if (!strcmp(dialect_names[i], name))
			return i;
	}
	return -1;
}
