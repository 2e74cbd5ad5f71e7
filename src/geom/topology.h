/* topology.h - what a triangle soup encloses: components, closedness, and the shells that bound its inside. */
#ifndef FIVECHECK_GEOM_TOPOLOGY_H
#define FIVECHECK_GEOM_TOPOLOGY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "geom/mesh.h"
#include "geom/vec3.h"

/* More than stl_read ever gives. */
#define TOPOLOGY_TRIANGLES_MAX (INT32_MAX / 3)

/* The shell of triangles that bound nothing: degenerate ones, and the second side of what is drawn from both sides. */
#define NO_SHELL UINT32_MAX

/* How the inside of a shell can be told. */
enum shell_kind {
	SHELL_EMPTY, /* it has no triangles */
	SHELL_ORIENTED, /* by the winding number: every edge is run through as often in one direction as in the other */
	SHELL_UNORIENTED, /* by the parity of a ray's crossings: an even number of triangles meets in every edge */
	SHELL_OPEN /* not at all: it has holes */
};

struct shell {
	enum shell_kind kind;
	bool flipped;	/* neighbouring triangles face opposite ways, or which way they face is not known */
	vec3 least, greatest;	/* bounds of its corners */
};

/* Vertices are the same when their coordinates are (-0 is 0). */
struct topology {
	size_t component_count;
	vec3 *component_point;	/* one vertex of each connected component */
	size_t open_edges;	/* sides, but not of degenerate triangles, that no side runs back along */
	size_t flipped_edges;	/* of those, sides that another triangle runs through in the same direction */
	size_t degenerate;	/* triangles whose corners are not three different points */
	size_t doubled;	/* triangles left out because the same triangle is there facing the other way */
	bool closed;	/* every edge is run through as often in one direction as in the other */
	bool plain;	/* closed without twins: the winding number of the whole mesh tells its inside */
	/*
	 * NULL where the mesh is plain and of one component. Else two shells for each component: 2 c are its
	 * triangles without a twin that faces the other way, 2 c + 1 one of each two twins.
	 */
	struct shell *shells;
	size_t shell_count;
	uint32_t *shell_of;	/* of each triangle, or NO_SHELL; NULL together with shells */
};

/* Of a mesh with at most TOPOLOGY_TRIANGLES_MAX triangles. Witnesses come in the order of the file. */
void topology_init(struct topology *topology, const struct mesh *mesh);
void topology_release(struct topology *topology);

/* Has it shells whose inside cannot be told? */
bool topology_is_open(const struct topology *topology);

#endif
