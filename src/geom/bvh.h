/* bvh.h - a mesh with a tree of axis-aligned boxes over it; each node has eight children. */
#ifndef FIVECHECK_GEOM_BVH_H
#define FIVECHECK_GEOM_BVH_H

#include <stddef.h>
#include <stdint.h>

#include "geom/mesh.h"
#include "geom/vec3.h"

enum { BVH_WIDTH = 8, BVH_LEAF_SIZE = 1 };

/*
 * The boxes of up to eight children side by side, relative to the tree's origin
 * and rounded outward. `count` > 0 is a leaf whose triangles begin at `first`;
 * `count` 0 is the inner node nodes[first].
 */
struct bvh_node {
	float centre[3][BVH_WIDTH];	/* mm */
	float half[3][BVH_WIDTH];
	uint32_t first[BVH_WIDTH];
	uint8_t count[BVH_WIDTH];
	uint32_t begin, total;	/* the run of triangles below */
	uint8_t used;	/* children in use; the boxes of the others are copies of the first */
};

/* mm, from the tree's origin: the box of a child. */
static inline vec3 bvh_child_centre(const struct bvh_node *node, int lane)
{
	return (vec3){node->centre[0][lane], node->centre[1][lane], node->centre[2][lane]};
}

static inline vec3 bvh_child_half(const struct bvh_node *node, int lane)
{
	return (vec3){node->half[0][lane], node->half[1][lane], node->half[2][lane]};
}

struct bvh {
	struct mesh mesh;	/* owned; triangles in the order of the leaves */
	struct bvh_node *nodes;	/* nodes[0] is the root */
	size_t node_count;
	vec3 origin;	/* middle of the bounds, mm */
	vec3 half;	/* half the size of the bounds */
	double radius;	/* mm: no vertex is farther from the origin */
	int simd_level;	/* of the tests of boxes and triangles (simd_level.h) */
};

/* Takes over the mesh, which is empty afterwards; it has at least one triangle. */
struct bvh *bvh_new(struct mesh *mesh);

/* From this number of triangles on, several threads pay. */
#define BVH_LARGE 50000

/* The same tree, built by up to `threads` threads if the mesh is large. */
struct bvh *bvh_new_by(struct mesh *mesh, int threads);
void bvh_free(struct bvh *bvh);

#endif
