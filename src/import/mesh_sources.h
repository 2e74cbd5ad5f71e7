/* mesh_sources.h - which paths of a file led to which meshes: paths from other computers are found by their ends. */
#ifndef FIVECHECK_IMPORT_MESH_SOURCES_H
#define FIVECHECK_IMPORT_MESH_SOURCES_H

#include "base/arena.h"
#include "base/diag.h"

struct mesh_source {
	const char *written, *found;
};

/* All zero is empty. */
struct mesh_sources {
	struct arena arena;
	struct mesh_source *items;
	size_t count, capacity;
};

void mesh_sources_release(struct mesh_sources *sources);

/* Notes that the mesh at a path was found in a file. Warns if another path led to the same file. NULL: does nothing. */
void mesh_sources_add(struct mesh_sources *sources, const char *written, const char *found, struct srcloc at,
		      struct diag *diag);

#endif
