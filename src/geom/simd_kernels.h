/* simd_kernels.h - the functions that are compiled for each level of SIMD; all levels give the same bits. */
#ifndef FIVECHECK_GEOM_SIMD_KERNELS_H
#define FIVECHECK_GEOM_SIMD_KERNELS_H

#include <stddef.h>

#include "geom/mesh.h"
#include "geom/simd_level.h"

struct box;
struct box_motion;
struct branch_caps;
struct bvh_node;

/* boxes_apart of boxes.h; both results are BVH_WIDTH long. */
typedef void boxes_apart_fn(const struct box_motion *motion, int side, const struct bvh_node *node,
			    const struct box *other, float enough, float *apart, float *lost);

/* support of support.h, for a direction in floats. */
typedef float support_fn(const mesh_triangle *triangles, size_t count, const float n[3]);

/*
 * reach[i] becomes the greatest n.p over the points p of the node's i-th box, relative to the tree's origin;
 * of children that are not in use, anything. The error is less than 8 roundings of float times |n| and the largest |p|.
 */
typedef void boxes_reach_fn(const struct bvh_node *node, const float n[3], float *reach);

/*
 * The same with the caps of the node's children (corner_runs.h): reach[i] is an upper bound of the greatest n.p over
 * the points of child i, at most the extent of its box. The error is less than 16 roundings: those of boxes_reach, for
 * the part of n across the cap's normal; two for this part, two for the product and the sum with the cap, and one for
 * the rounding of n.
 */
typedef void caps_reach_fn(const struct bvh_node *node, const struct branch_caps *caps, const float n[3], float *reach);

/* The index of the greatest of BVH_WIDTH numbers, none of them NaN, whose bits are set; the first of equal ones. */
typedef int greatest_of_fn(const float *numbers, unsigned among);

/*
 * near2[i] becomes a lower bound of the squared distance in mm of p, relative to the tree's origin, from the node's
 * i-th box. `slack` mm: at least 8 roundings of float times the largest coordinate of p and of the boxes. Bit i of the
 * result: it is at most within2, and the child is in use.
 */
typedef unsigned boxes_near_fn(const struct bvh_node *node, const float p[3], float slack, float within2, float *near2);

/*
 * The greatest n.p over points in groups of eight, at least one group: x of the first eight, y, z, x of the next. The
 * error is less than 6 roundings of float times |n| and the largest |p|.
 */
typedef float points_reach_fn(const float *points, size_t groups, const float n[3]);

/* A triangle's box: the least x y z, 0, the greatest x y z with reversed signs, 0. So one minimum widens everything. */
struct bvh_item {
	float bounds[8];
};

/* *box encloses all items; *middles encloses the sums of each item's least and greatest corner. */
typedef void bvh_items_bounds_fn(const struct bvh_item *items, size_t count, struct bvh_item *box,
				 struct bvh_item *middles);

/* The functions of one level. */
struct simd_kernels {
	boxes_apart_fn *boxes_apart;
	support_fn *support;
	boxes_near_fn *boxes_near;
	boxes_reach_fn *boxes_reach;
	greatest_of_fn *greatest_of;
	caps_reach_fn *caps_reach;
	points_reach_fn *points_reach;
	bvh_items_bounds_fn *bvh_items_bounds;
};

extern const struct simd_kernels simd_kernels_scalar;
#if LANES_BEST == LANES_AVX2
extern const struct simd_kernels simd_kernels_sse2;
extern const struct simd_kernels simd_kernels_avx2;	/* only if simd_level() allows it */
#endif

/* The functions of a level that this processor has. */
const struct simd_kernels *simd_kernels_at_level(int level);

#endif
