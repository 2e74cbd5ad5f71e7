/* stress_positions.h - awkward positions of two triangles with their distances, and the disguises that leave it known. */
#ifndef FIVECHECK_TESTS_STRESS_POSITIONS_H
#define FIVECHECK_TESTS_STRESS_POSITIONS_H

#include "geom/tri.h"

#define MISS 0x1p-30	/* 1e-9 and a half */

struct position {
	const char *name;
	tri a, b;
	double distance;
};

static const struct position positions[] = {
	{"coplanar, overlapping", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{1, 1, 0}, {5, 1, 0}, {1, 5, 0}}}, 0},
	{"coplanar, one in the other", {{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}},
	 {{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}}, 0},
	{"coplanar, apart", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{0, -2, 0}, {4, -2, 0}, {2, -6, 0}}}, 2},
	{"coplanar, a miss", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}},
	 {{{0, -MISS, 0}, {4, -MISS, 0}, {2, -6, 0}}}, MISS},
	{"parallel faces, a miss", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}},
	 {{{1, 1, MISS}, {2, 1, MISS}, {1, 2, MISS}}}, MISS},
	{"the same triangle", {{{0, 1, 2}, {4, 0, 3}, {0, 4, 5}}}, {{{0, 1, 2}, {4, 0, 3}, {0, 4, 5}}}, 0},
	{"shared edge", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{0, 0, 0}, {4, 0, 0}, {1, -3, 7}}}, 0},
	{"shared corner", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{0, 0, 0}, {-4, -1, 1}, {-1, -4, 1}}}, 0},
	{"corner on face", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{1, 1, 0}, {5, 2, 3}, {0, 2, 4}}}, 0},
	{"corner over face, a miss", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}},
	 {{{1, 1, MISS}, {5, 2, 3}, {0, 2, 4}}}, MISS},
	{"corner on edge", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{2, 0, 0}, {2, -3, 1}, {3, -3, -1}}}, 0},
	{"edges that cross", {{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}}, {{{0, -1, 0}, {0, 1, 0}, {0, 0, 1}}}, 0},
	{"edges that miss", {{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}},
	 {{{0, -1, MISS}, {0, 1, MISS}, {0, 0, 1}}}, MISS},
	{"parallel edges, a miss", {{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}},
	 {{{-2, 0, MISS}, {2, 0, MISS}, {0, 1, 1}}}, MISS},
	{"parallel edges that lie on each other", {{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}},
	 {{{-2, 0, 0}, {0, 0, 0}, {0, 1, 1}}}, 0},
	{"edges at 1e-8 rad that cross", {{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}},
	 {{{-1, -1e-8, 0}, {1, 1e-8, 0}, {0, 0, 1}}}, 0},
	{"edges at 1e-8 rad that miss", {{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}},
	 {{{-1, -1e-8, MISS}, {1, 1e-8, MISS}, {0, 0, 1}}}, MISS},
	{"slivers of 1e8 that cross", {{{-1e4, 0, 0}, {1e4, 0, 0}, {0, 2e-4, 0}}},
	 {{{0, 1e-4, -1e4}, {0, 1e-4, 1e4}, {1e-4, 1e-4, 0}}}, 0},
	{"slivers of 1e8 side by side", {{{-1e4, 0, 0}, {1e4, 0, 0}, {0, 1e-4, 0}}},
	 {{{-1e4, 0, 1}, {1e4, 0, 1}, {0, -1e-4, 1}}}, 1},
	{"a segment over a face", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{1, 1, 1}, {1, 1, 3}, {1, 1, 2}}}, 1},
	{"a segment through a face", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{1, 1, -1}, {1, 1, 3}, {1, 1, 2}}}, 0},
	{"a point on a face", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}}, 0},
	{"a point beside a face", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}},
	 {{{1, -MISS, 0}, {1, -MISS, 0}, {1, -MISS, 0}}}, MISS},
	{"two points", {{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}}, {{{1, 2, 4}, {1, 2, 4}, {1, 2, 4}}}, 1},
	{"the same point", {{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}}, {{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}}, 0},
	{"collinear segments, apart", {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}, {{{5, 0, 0}, {4, 0, 0}, {7, 0, 0}}}, 2},
	{"collinear segments, overlapping", {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}},
	 {{{5, 0, 0}, {1, 0, 0}, {7, 0, 0}}}, 0},
	{"minus zero", {{{-0.0, -0.0, -0.0}, {4, -0.0, 0}, {0, 4, -0.0}}}, {{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}}, 1},
	{"denormals, on a face", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}},
	 {{{5e-324, 5e-324, 0}, {5, 2, 3}, {0, 2, 4}}}, 0},
	{"denormals, a point", {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}},
	 {{{1, 1, 1}, {1, 1 + 0x1p-52, 1}, {1, 1, 1}}}, 1},
};

/* One of the 48 symmetries of a cube: lengths stay as they are, to the last bit. */
static inline vec3 turned(vec3 p, int symmetry)
{
	static const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
	const double c[3] = {p.x, p.y, p.z};
	const int *order = orders[symmetry / 8];

	return (vec3){symmetry & 1 ? -c[order[0]] : c[order[0]], symmetry & 2 ? -c[order[1]] : c[order[1]],
		      symmetry & 4 ? -c[order[2]] : c[order[2]]};
}

/* Corners in another order, another symmetry, another size. */
static inline tri disguise(const tri *t, int rotation, bool mirrored, int symmetry, double scale)
{
	tri out;

	for (int k = 0; k < 3; k++)
		out.p[k] = vec3_scale(scale, turned(t->p[(rotation + (mirrored ? 3 - k : k)) % 3], symmetry));
	return out;
}

enum { POSITIONS = sizeof(positions) / sizeof(positions[0]), DISGUISES = 6 * 6 * 48 * 4 };

/* Disguise k of a position: the order of the corners of each, one of the symmetries of a cube, one of four sizes. */
static inline double disguise_pair(const struct position *position, int k, tri *a, tri *b)
{
	static const double scales[] = {1, 0x1p-17, 0x1p-3, 0x1p20};
	double scale = scales[k % 4];
	int of_a = k / 4 % 6, of_b = k / 24 % 6, symmetry = k / 144;

	*a = disguise(&position->a, of_a % 3, of_a > 2, symmetry, scale);
	*b = disguise(&position->b, of_b % 3, of_b > 2, symmetry, scale);
	return scale * position->distance;
}

#endif
