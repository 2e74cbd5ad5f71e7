/* mesh_helper.h - reads meshes with the program fivecheck-mesh, which reads formats that the import does not. */
#ifndef FIVECHECK_IMPORT_MESH_HELPER_H
#define FIVECHECK_IMPORT_MESH_HELPER_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "import/mesh_build.h"

struct mesh_part {
	char name[64];	/* in the file; may be empty */
	struct mesh_build build;
};

/* All zero is an empty list. */
struct mesh_parts {
	struct mesh_part *items;	/* owned, with their triangles */
	size_t count, capacity;
};

/*
 * Runs the program on the file, with a limit of time and memory, and adds its meshes, in mm; `scale`: mm per unit of
 * the file. `y_up`: the file's Y points up, as in glTF; it becomes Z. False, reported: there is no such program, or the
 * file is faulty.
 */
bool mesh_helper_read(struct mesh_parts *parts, const char *path, double scale, bool y_up, struct diag *diag);
void mesh_parts_release(struct mesh_parts *parts);

#endif
