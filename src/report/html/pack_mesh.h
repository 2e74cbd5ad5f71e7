/*
 * pack_mesh.h - a mesh as report_data.h, "MESHES", describes: its vertices moved to a grid, then coded (mesh_coder.h).
 */
#ifndef FIVECHECK_REPORT_HTML_PACK_MESH_H
#define FIVECHECK_REPORT_HTML_PACK_MESH_H

#include <stddef.h>

#include "base/strbuf.h"
#include "geom/mesh.h"
#include "geom/xform.h"

/* mm: the smallest step of the grid; a finer one would not be visible. */
#define PACK_MESH_STEP 0.02

struct packed_mesh {
	size_t vertices, triangles;	/* triangles without area on the grid are left out */
	vec3 origin;	/* mm */
	double step;	/* mm, the same in all directions */
};

/*
 * Appends the mesh, moved by `place`. Every vertex is within PACK_MESH_ERROR steps of its exact position. The mesh is
 * not empty and has fewer than 2^30 triangles.
 */
#define PACK_MESH_ERROR 0.8661	/* half the diagonal of a cube, rounded up */
void pack_mesh_add(struct strbuf *out, const struct mesh *mesh, const xform *place, struct packed_mesh *packed);

#endif
