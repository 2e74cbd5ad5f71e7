/* branch.h - one box of a tree as a walk over two trees meets it: an inner node, or a leaf. */
#ifndef FIVECHECK_SCENE_BRANCH_H
#define FIVECHECK_SCENE_BRANCH_H

#include <math.h>

#include "geom/boxes.h"
#include "geom/bvh.h"
#include "scene/leaf.h"

struct branch {
	struct box box;
	float size;	/* mm: the box's diagonal */
	struct leaf leaf;	/* count 0: the inner node nodes[leaf.first] */
};

static inline struct branch branch_of(struct box box, struct leaf leaf)
{
	const float *h = box.half;

	return (struct branch){box, 2 * sqrtf(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]), leaf};
}

static inline struct branch branch_root(const struct bvh *bvh)
{
	return branch_of(box_whole(bvh), (struct leaf){0, 0});
}

static inline struct branch branch_child(const struct bvh_node *node, int lane)
{
	return branch_of(box_of(node, lane), (struct leaf){node->first[lane], node->count[lane]});
}

/* A branch of each body's tree, and the least distance (mm) that their boxes allow. */
struct branch_pair {
	struct branch a, b;
	float least;
};

/* Of two branches, not both leaves, is a the one to open? The larger that can be. */
static inline bool branch_opens_first(const struct branch *a, const struct branch *b)
{
	return b->leaf.count || (!a->leaf.count && a->size >= b->size);
}

#endif
