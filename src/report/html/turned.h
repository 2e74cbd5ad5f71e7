/*
 * turned.h - represents meshes of turned bodies, as tool_solid makes them, by their outline instead of their triangles.
 */
#ifndef FIVECHECK_REPORT_HTML_TURNED_H
#define FIVECHECK_REPORT_HTML_TURNED_H

#include <stdbool.h>
#include <stddef.h>

#include "geom/mesh.h"

struct turned_corner {
	double r, z;	/* mm */
};

/*
 * Regular polygons of `facets` vertices about the Z axis, one for each corner of the outline, the first vertex at y =
 * 0; bands between neighbours, and a cap at each end.
 */
struct turned {
	size_t facets;
	struct turned_corner *corners;	/* from the top down; owned */
	size_t count;
};

/*
 * Finds the outline of a mesh. Every vertex of the mesh is within TURNED_ERROR of one of the polygons' vertices or
 * centres. False: the mesh is not such a body.
 */
#define TURNED_ERROR 0.005
#define TURNED_UNIT 0.001	/* mm: how exactly a report tells the outline */
bool turned_init(struct turned *turned, const struct mesh *mesh);
void turned_release(struct turned *turned);

#endif
