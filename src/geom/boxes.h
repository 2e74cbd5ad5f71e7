/* boxes.h - lower bounds of the distance of eight boxes of one body from one box of another body that moves. */
#ifndef FIVECHECK_GEOM_BOXES_H
#define FIVECHECK_GEOM_BOXES_H

#include <stdbool.h>

#include "geom/bvh.h"
#include "geom/simd_kernels.h"
#include "geom/xform.h"

/* A rotation matrix with its absolute values, and a translation. Rows first: r[i] gives coordinate i. */
struct box_map {
	float r[3][3];
	float abs_r[3][3];
	float t[3];
};

struct box {
	float centre[3];
	float half[3];
};

/*
 * The pose of body b relative to body a at the two ends of a motion, for boxes, and how far b may be outside the hull
 * of the two. View 0 maps b's boxes into a's frame, view 1 maps a's into b's; both frames have their body's origin.
 */
struct box_view {
	struct box_map ends[2];
	float axis_displacement[3];	/* mm along each axis of the frame, beyond the hull */
	float displacement;	/* mm in any direction, in addition; includes rounding */
};

struct box_motion {
	struct box_view views[2];
	boxes_apart_fn *apart;	/* the fastest version for this processor */
	bool still;	/* both ends are the same */
};

/*
 * poses: b's mesh coordinates in a's, at both ends. axis_displacement and displacement, one for each view, are as above
 * but exact; the rounding of the box tests is added to a displacement.
 */
void box_motion_init(struct box_motion *motion, const struct bvh *a, const struct bvh *b, const xform *poses,
		     const vec3 *axis_displacement, const double *displacement);

static inline struct box box_of(const struct bvh_node *node, int lane)
{
	return (struct box){{node->centre[0][lane], node->centre[1][lane], node->centre[2][lane]},
			    {node->half[0][lane], node->half[1][lane], node->half[2][lane]}};
}

struct box box_whole(const struct bvh *bvh);

/*
 * For each child of `node` a lower bound, in mm, of its distance to `other` throughout the motion; 0 if they may touch.
 * `side` is 0 if the node is a's and the box b's, 1 the other way round. `lost` receives, for each child, about how
 * much of the bound is lost because the boxes move (mm). If every child is farther than `enough` (mm, at least 0) the
 * bounds are not the best possible ones.
 */
void boxes_apart(const struct box_motion *motion, int side, const struct bvh_node *node, const struct box *other,
		 float enough, float apart[BVH_WIDTH], float lost[BVH_WIDTH]);

/* The same for one box of a and one of b. */
float box_pair_apart(const struct box_motion *motion, const struct box *a, const struct box *b, float *lost);

#endif
