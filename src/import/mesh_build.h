/* mesh_build.h - collects triangles with coordinates in double into a mesh. */
#ifndef FIVECHECK_IMPORT_MESH_BUILD_H
#define FIVECHECK_IMPORT_MESH_BUILD_H

#include <stdbool.h>
#include <stddef.h>

#include "geom/mesh.h"
#include "geom/vec3.h"

/* All zero but for the scale (mm per unit of the corners) is an empty collection. */
struct mesh_build {
	double scale;
	struct mesh mesh;
	size_t capacity;
};

/* Adds a triangle. False, and nothing is added: a coordinate is not finite, or beyond 10 km. */
bool mesh_build_add(struct mesh_build *build, const vec3 corners[3]);

/* Hands the mesh over; the collection is then empty. */
void mesh_build_finish(struct mesh_build *build, struct mesh *out);
void mesh_build_discard(struct mesh_build *build);

/*
 * The solids that machine files describe by sizes, mm. The block has a corner at 0; the others stand on 0, along Z.
 * False, and nothing is added: a size is not finite, or beyond 10 km.
 */
bool mesh_build_block(struct mesh_build *build, vec3 size);

/*
 * A cylinder or a cone with the given radii at 0 and at `height`. Its facets enclose the true solid and deviate from it
 * by at most 0.01 mm.
 */
bool mesh_build_frustum(struct mesh_build *build, double radius, double radius_end, double height);

#endif
