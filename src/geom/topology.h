/* topology.h - the topology of a triangle soup: components, closedness, and the shells that bound its inside. */
#ifndef FIVECHECK_GEOM_TOPOLOGY_H
#define FIVECHECK_GEOM_TOPOLOGY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "geom/mesh.h"
#include "geom/vec3.h"

/* More triangles than stl_read ever returns. */
#define TOPOLOGY_TRIANGLES_MAX (INT32_MAX / 3)

/*
 * The shell of triangles that bound nothing: degenerate ones, and the second side of triangles drawn from both sides.
 */
#define NO_SHELL UINT32_MAX

/* How to find the inside of a shell. */
enum shell_kind {
	SHELL_EMPTY, /* it has no triangles */
	SHELL_ORIENTED, /* by the winding number: every edge is used equally often in both directions */
	SHELL_UNORIENTED, /* by the parity of a ray's crossings: an even number of triangles meets at every edge */
	SHELL_OPEN /* impossible: it has holes */
};

struct shell {
	enum shell_kind kind;
	bool flipped;	/* neighbouring triangles face opposite ways, or their direction is unknown */
	vec3 least, greatest;	/* bounds of its corners */
};

/* Vertices with equal coordinates are the same (-0 is 0). */
struct topology {
	size_t component_count;
	vec3 *component_point;	/* one vertex of each connected component */
	size_t open_edges;	/* sides of nondegenerate triangles without a side in the opposite direction */
	size_t flipped_edges;	/* of those, sides that another triangle has in the same direction */
	size_t degenerate;	/* triangles whose corners are not three different points */
	size_t doubled;	/* triangles ignored because the same triangle exists with the opposite direction */
	bool closed;	/* every edge is used equally often in both directions */
	bool plain;	/* closed without twins: the winding number of the whole mesh shows its inside */
	/*
	 * NULL if the mesh is plain and has one component. Otherwise two shells for each component c: shell 2 c has the
	 * triangles without a twin of the opposite direction, shell 2 c + 1 has one of each two twins.
	 */
	struct shell *shells;
	size_t shell_count;
	uint32_t *shell_of;	/* of each triangle, or NO_SHELL; NULL together with shells */
};

/* For a mesh with at most TOPOLOGY_TRIANGLES_MAX triangles. Witnesses come in the order of the file. */
void topology_init(struct topology *topology, const struct mesh *mesh);
void topology_release(struct topology *topology);

/* Does it have shells without a defined inside? */
bool topology_is_open(const struct topology *topology);

#endif
