#include "import/mesh_sources.h"

#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/mem.h"
#include "machine/xml/xml_element.h"

void mesh_sources_release(struct mesh_sources *sources)
{
	arena_release(&sources->arena);
	free(sources->items);
	*sources = (struct mesh_sources){0};
}

static char plain(char letter)
{
	return letter == '\\' ? '/' : ascii_lower(letter);
}

/* Do the paths differ in more than upper case and the kind of slashes? */
static bool is_other_path(const char *a, const char *b)
{
	while (*a && plain(*a) == plain(*b)) {
		a++;
		b++;
	}
	return *a || *b;
}

void mesh_sources_add(struct mesh_sources *sources, const char *written, const char *found, struct srcloc at,
		      struct diag *diag)
{
	for (size_t i = 0; sources && i < sources->count; i++) {
		const struct mesh_source *other = &sources->items[i];

		if (strcmp(other->found, found) != 0)
			continue;
		if (is_other_path(other->written, written))
			diag_warning(diag, at,
				     "'%s' and '%s' were both found as '%s': if they are two meshes, put them into "
				     "folders with their names",
				     xml_quote(other->written).text, xml_quote(written).text, xml_quote(found).text);
		return;
	}
	if (!sources)
		return;
	sources->items = mem_grow(sources->items, &sources->capacity, sources->count + 1, sizeof(*sources->items));
	sources->items[sources->count++] = (struct mesh_source){arena_strdup(&sources->arena, written),
								 arena_strdup(&sources->arena, found)};
}
