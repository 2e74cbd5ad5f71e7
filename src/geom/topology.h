/* topology.h - what a triangle soup encloses: components, closedness, and which points are inside. */
#ifndef FIVECHECK_GEOM_TOPOLOGY_H
#define FIVECHECK_GEOM_TOPOLOGY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "geom/mesh.h"
#include "geom/vec3.h"

/* More than stl_read ever gives. */
#define TOPOLOGY_TRIANGLES_MAX (INT32_MAX / 3)

/* Vertices are the same when their coordinates are (-0 is 0). */
struct topology {
	size_t component_count;
	vec3 *witness;	/* one vertex of each connected component */
	size_t open_edges;	/* sides, but not of degenerate triangles, that no side runs back along */
	size_t flipped_edges;	/* of those, sides that another triangle runs through in the same direction */
	size_t degenerate;	/* triangles whose corners are not three different points */
	bool closed;	/* every edge is run through as often in one direction as in the other */
};

/* Of a mesh with at most TOPOLOGY_TRIANGLES_MAX triangles. Witnesses come in the order of the file. */
void topology_init(struct topology *topology, const struct mesh *mesh);
void topology_release(struct topology *topology);

/*
 * The winding number of a closed mesh about a point that is not on its
 * surface: the sum of the signed solid angles of its triangles over 4 pi (Van
 * Oosterom and Strackee, "The solid angle of a plane triangle", 1983). Nonzero
 * is inside; a cavity counts 0.
 */
int mesh_winding_number(const struct mesh *mesh, vec3 point);

#endif
