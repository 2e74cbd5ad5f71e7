/* mesh.h - a triangle soup, as STL has it. */
#ifndef FIVECHECK_GEOM_MESH_H
#define FIVECHECK_GEOM_MESH_H

#include <stddef.h>

#include "geom/vec3.h"

/* Three corners of three coordinates each. */
typedef struct mesh_triangle {
	float v[3][3];
} mesh_triangle;

/* Owns its triangles. All zero is the empty mesh. Coordinates are finite. */
struct mesh {
	mesh_triangle *triangles;
	size_t count;
	double rounding;	/* mm: no stored coordinate is farther than this from the true one */
};

void mesh_release(struct mesh *mesh);

static inline vec3 mesh_corner(const mesh_triangle *t, int corner)
{
	return (vec3){t->v[corner][0], t->v[corner][1], t->v[corner][2]};
}

/* The least and greatest coordinates; the mesh is not empty. */
void mesh_bounds(const struct mesh *mesh, vec3 *least, vec3 *greatest);

/* Multiplies every coordinate (for files in inches or metres), and adds the rounding to `rounding`. */
void mesh_scale(struct mesh *mesh, double factor);

#endif
