/* bvh_pair.h - a pair of subtrees, one of each body's tree: the unit of work when two trees are traversed. */
#ifndef FIVECHECK_SCENE_BVH_PAIR_H
#define FIVECHECK_SCENE_BVH_PAIR_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#include "geom/boxes.h"
#include "geom/bvh.h"

/* Successive triangles of one body. */
struct leaf {
	uint32_t first;
	uint8_t count;
};

/*
 * A box around the triangles below a leaf or an inner node, relative to the tree's origin (mm). The box of a node is as
 * tight as those of its children.
 */
void leaf_box(const struct bvh *bvh, struct leaf leaf, vec3 *centre, vec3 *half);

struct subtree {
	struct box box;
	float size;	/* mm: the box's diagonal */
	struct leaf leaf;	/* count 0: an inner node, nodes[leaf.first] */
};

static inline struct subtree subtree_of(struct box box, struct leaf leaf)
{
	const float *h = box.half;

	return (struct subtree){box, 2 * sqrtf(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]), leaf};
}

static inline struct subtree subtree_root(const struct bvh *bvh)
{
	return subtree_of(box_whole(bvh), (struct leaf){0, 0});
}

static inline struct subtree subtree_child(const struct bvh_node *node, int lane)
{
	return subtree_of(box_of(node, lane), (struct leaf){node->first[lane], node->count[lane]});
}

/* A subtree of each body's tree, and a lower bound of the distance (mm) from their boxes. */
struct bvh_pair {
	struct subtree a, b;
	float least;
};

/* Should a be opened instead of b? The larger of the two is opened, unless it is a leaf. At most one is a leaf. */
static inline bool bvh_pair_opens_a(const struct subtree *a, const struct subtree *b)
{
	return b->leaf.count || (!a->leaf.count && a->size >= b->size);
}

#endif
