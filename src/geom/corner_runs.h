/*
 * corner_runs.h - for support functions: the corners of a mesh, listed once for each small branch of its tree, and how
 * far the larger branches reach along their normals.
 */
#ifndef FIVECHECK_GEOM_CORNER_RUNS_H
#define FIVECHECK_GEOM_CORNER_RUNS_H

#include <stddef.h>

#include "geom/bvh.h"
#include "geom/simd_kernels.h"

/*
 * A branch of at most this number of triangles has a run, if the branch above has more. Measured: 64 corners or fewer,
 * which are examined in less time than the boxes above their triangles.
 */
enum { RUN_TRIANGLES = 64 };

/*
 * A mesh of more triangles has no runs: they take about ten bytes per triangle, and their gain does not grow with the
 * mesh.
 */
enum { RUN_MESH_TRIANGLES = 100000 };

/*
 * The greatest n.p over the points p of each child of a node, along the child's own mean normal n, in the order of its
 * boxes. With any a >= 0, m = a n + r, so along m no point is farther than a times this plus the extent of the child's
 * box along r. Across a smooth surface this is much less than the extent of the box along m. A child without a normal
 * has 0.
 */
struct branch_caps {
	float normal[3][BVH_WIDTH];	/* not longer than 1, up to rounding */
	float reach[BVH_WIDTH];	/* mm, from the tree's origin, rounded up */
};

struct corner_runs {
	float *points;	/* owned: groups of eight as for points_reach_fn, from the tree's origin */
	struct corner_run {
		uint32_t first, groups;	/* 0 groups: the branch has no run of its own */
		uint32_t caps;	/* of a branch with more triangles than a run: number of its caps, from 1; 0: none */
	} *runs;	/* owned: by node of the tree */
	struct branch_caps *caps;	/* owned */
	const struct simd_kernels *kernels;	/* of the tree's level */
};

struct corner_runs *corner_runs_new(const struct bvh *bvh);

/* NULL is none. */
void corner_runs_free(struct corner_runs *runs);

/* The point of a run that reaches farthest along n, approximately. */
vec3 corner_runs_farthest(const struct corner_runs *runs, const struct corner_run *run, const float n[3]);

#endif
