/* tri.h - two triangles: whether they meet, their distance, and the axes that can separate them. */
#ifndef FIVECHECK_GEOM_TRI_H
#define FIVECHECK_GEOM_TRI_H

#include <float.h>
#include <math.h>
#include <stdbool.h>

#include "geom/vec3.h"

/* Closed: includes its edges and corners. If corners coincide or are collinear it is that segment or point. */
typedef struct tri {
	vec3 p[3];
} tri;

#define TRI_AXES_MAX 11

/*
 * The error of tri_distance is at most this share of the pair's size, tri_pair_size(a, b). The tests allow a sixth of
 * it.
 */
#define TRI_DISTANCE_ERROR (32 * DBL_EPSILON)

/* The greatest coordinate of either triangle, in magnitude. */
static inline double tri_pair_size(const tri *a, const tri *b)
{
	double size = 0;

	for (int i = 0; i < 3; i++) {
		const double c[6] = {a->p[i].x, a->p[i].y, a->p[i].z, b->p[i].x, b->p[i].y, b->p[i].z};

		for (int k = 0; k < 6; k++)
			size = fabs(c[k]) > size ? fabs(c[k]) : size;
	}
	return size;
}

/*
 * The paper's axes (Chen, Lin and Chang). Not coplanar: both normals and the nine cross products of edges, 11;
 * coplanar: the normal of a times each edge of a, that of b times each edge of b, 6. Not normalised. Axes that nearly
 * vanish are left out, so there may be none at all (two points). Returns their number. Any n, or -n, along which
 * tri_gap exceeds tri_gap_error proves the triangles apart, however it was found.
 */
int tri_axes(const tri *a, const tri *b, vec3 axes[TRI_AXES_MAX]);

/*
 * Do the triangles share a point? An axis of tri_axes separates them if its gap exceeds tri_gap_error. The answer is
 * yes if none does, so triangles that touch are never called apart. For a triangle without a normal those axes are not
 * enough: then tri_distance decides. Exact for integer coordinates up to 2^14.
 */
bool tri_meet(const tri *a, const tri *b);

/*
 * The distance between the triangles, and a pair of closest points, each in its
 * triangle and that far apart to within TRI_DISTANCE_ERROR; 0 when they meet.
 * Coordinates below 1e70 in magnitude; edges shorter than 1e-70 count as points.
 */
double tri_distance(const tri *a, const tri *b, vec3 *on_a, vec3 *on_b);

/* The gap along n, which need not have unit length: least n.q over b minus greatest n.p over a. */
static inline double tri_gap(const tri *a, const tri *b, vec3 n)
{
	double p0 = vec3_dot(n, a->p[0]), p1 = vec3_dot(n, a->p[1]), p2 = vec3_dot(n, a->p[2]);
	double q0 = vec3_dot(n, b->p[0]), q1 = vec3_dot(n, b->p[1]), q2 = vec3_dot(n, b->p[2]);
	double p = p0 > p1 ? p0 : p1, q = q0 < q1 ? q0 : q1;

	return (q < q2 ? q : q2) - (p > p2 ? p : p2);
}

/*
 * The largest rounding of tri_gap: each projection has three roundings of half an epsilon, at most size |n|_1 each, and
 * the difference one of twice that: 4 epsilon in all to first order. DBL_MIN covers products that underflow.
 */
static inline double tri_gap_error(double pair_size, vec3 n)
{
	return 5 * DBL_EPSILON * pair_size * (fabs(n.x) + fabs(n.y) + fabs(n.z)) + DBL_MIN;
}

#endif
