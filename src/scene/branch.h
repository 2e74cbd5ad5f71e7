/* branch.h - one box of a tree as a walk over two trees meets it: an inner node, or a leaf. */
#ifndef FIVECHECK_SCENE_BRANCH_H
#define FIVECHECK_SCENE_BRANCH_H

#include <math.h>

#include "geom/boxes.h"
#include "geom/bvh.h"
#include "scene/leaf.h"

struct branch {
	struct box box;
	struct leaf leaf;	/* count 0: the inner node nodes[leaf.first] */
};

static inline struct branch branch_root(const struct bvh *bvh)
{
	return (struct branch){box_whole(bvh), {0, 0}};
}

static inline struct branch branch_child(const struct bvh_node *node, int lane)
{
	return (struct branch){box_of(node, lane), {node->first[lane], node->count[lane]}};
}

/* A branch of each body's tree, and the least distance (mm) that their boxes allow. */
struct branch_pair {
	struct branch a, b;
	float least;
};

/* The diagonal, mm. */
static inline float branch_size(const struct branch *branch)
{
	const float *h = branch->box.half;

	return 2 * sqrtf(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]);
}

/* Of two branches, not both leaves, is a the one to open? The larger that can be. */
static inline bool branch_opens_first(const struct branch *a, const struct branch *b)
{
	return b->leaf.count || (!a->leaf.count && branch_size(a) >= branch_size(b));
}

#endif
