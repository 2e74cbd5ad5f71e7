/*
 * exact_tri.h - exact truth about triangles with integer corners: every feature pair is examined in 128-bit integers,
 * and only the last quotient is rounded (to long double). Coordinates up to 2^18.
 */
#ifndef FIVECHECK_TESTS_EXACT_TRI_H
#define FIVECHECK_TESTS_EXACT_TRI_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

__extension__ typedef __int128 wide;

typedef struct ivec {
	wide x, y, z;
} ivec;

typedef struct itri {
	ivec p[3];
} itri;

static inline uint64_t random_bits(uint64_t *state)
{
	*state ^= *state << 13;
	*state ^= *state >> 7;
	*state ^= *state << 17;
	return *state;
}

/* In [-m, m]. */
static inline int random_int(uint64_t *state, int m)
{
	return (int)(random_bits(state) >> 16 & 0x7fffffff) % (2 * m + 1) - m;
}

static inline ivec random_ivec(uint64_t *state, int m)
{
	ivec v = {random_int(state, m), random_int(state, m), random_int(state, m)};

	return v;
}

static inline ivec isub(ivec a, ivec b)
{
	return (ivec){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline ivec imad(ivec a, int s, ivec b)
{
	return (ivec){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

static inline wide idot(ivec a, ivec b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline ivec icross(ivec a, ivec b)
{
	return (ivec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline ivec iedge(const itri *t, int k)
{
	return isub(t->p[(k + 1) % 3], t->p[k]);
}

static inline void offer(long double *best, wide numerator, wide denominator)
{
	long double value = (long double)numerator / (long double)denominator;

	if (value < *best)
		*best = value;
}

static inline void offer_edges(long double *best, const itri *a, int i, const itri *b, int j)
{
	ivec d = iedge(a, i), e = iedge(b, j), r = isub(b->p[j], a->p[i]), n = icross(d, e);
	wide nn = idot(n, n), s = idot(icross(r, e), n), t = idot(icross(r, d), n), h = idot(r, n);

	if (nn > 0 && s >= 0 && s <= nn && t >= 0 && t <= nn)
		offer(best, h * h, nn);
}

static inline void offer_corner_edge(long double *best, ivec q, const itri *t, int k)
{
	ivec d = iedge(t, k), r = isub(q, t->p[k]), c = icross(r, d);
	wide dd = idot(d, d), s = idot(r, d);

	offer(best, idot(r, r), 1);
	if (dd > 0 && s >= 0 && s <= dd)
		offer(best, idot(c, c), dd);
}

static inline void offer_corner_face(long double *best, ivec q, const itri *t)
{
	ivec n = icross(iedge(t, 0), iedge(t, 1));
	wide nn = idot(n, n), h = idot(n, isub(q, t->p[0]));

	for (int k = 0; k < 3; k++) {
		if (idot(icross(n, iedge(t, k)), isub(q, t->p[k])) < 0)
			return;
	}
	if (nn > 0)
		offer(best, h * h, nn);
}

/* Does edge k of s cross the plane of t inside of t? Edges in the plane are left to the other features. */
static inline bool pierces(const itri *s, int k, const itri *t)
{
	ivec n = icross(iedge(t, 0), iedge(t, 1)), d = iedge(s, k);
	wide h0 = idot(n, isub(s->p[k], t->p[0])), h1 = idot(n, isub(s->p[(k + 1) % 3], t->p[0]));
	int positive = 0, negative = 0;

	if ((h0 > 0 && h1 > 0) || (h0 < 0 && h1 < 0) || (h0 == 0 && h1 == 0))
		return false;
	for (int m = 0; m < 3; m++) {
		wide volume = idot(icross(d, isub(t->p[m], s->p[k])), isub(t->p[(m + 1) % 3], s->p[k]));

		positive += volume > 0;
		negative += volume < 0;
	}
	return positive == 0 || negative == 0;
}

/* The squared distance; exactly 0 when they meet. */
static inline long double true_distance2(const itri *a, const itri *b)
{
	long double best = HUGE_VALL;

	for (int i = 0; i < 3; i++) {
		if (pierces(a, i, b) || pierces(b, i, a))
			return 0;
		offer_corner_face(&best, a->p[i], b);
		offer_corner_face(&best, b->p[i], a);
		for (int j = 0; j < 3; j++) {
			offer_edges(&best, a, i, b, j);
			offer_corner_edge(&best, a->p[i], b, j);
			offer_corner_edge(&best, b->p[i], a, j);
		}
	}
	return best;
}

/* ---- pairs of every kind ---- */

enum kind {
	TINY_GRID,	/* touching, coplanar and degenerate pairs abound */
	GRID,
	COPLANAR,
	SHARED_CORNER,
	SHARED_EDGE,
	NEEDLES,	/* one short edge */
	CAPS,	/* three nearly collinear corners */
	PARALLEL_EDGES,
	LATTICE,	/* edges as nearly parallel, and caps as low, as integers can make them */
	DEGENERATE,	/* segments and points */
	GRAZING,	/* a corner on, or one unit beside, the other's plane, edge or corner */
	KINDS
};

static inline itri random_itri(uint64_t *state, int m)
{
	return (itri){{random_ivec(state, m), random_ivec(state, m), random_ivec(state, m)}};
}

static inline itri needle(uint64_t *state, int m)
{
	itri t = random_itri(state, m);

	t.p[2] = imad(t.p[random_int(state, 1) > 0], 1, random_ivec(state, 1));
	return t;
}

static inline itri cap(uint64_t *state, int m)
{
	ivec p = random_ivec(state, m / 4), d = random_ivec(state, m / 4);
	itri t = {{p, imad(p, 3, d), imad(imad(p, 1, d), 1, random_ivec(state, 1))}};

	return t;
}

static inline itri degenerate(uint64_t *state, int m)
{
	ivec p = random_ivec(state, m / 4), d = random_ivec(state, m / 8);
	itri t = {{p, imad(p, random_int(state, 3), d), imad(p, random_int(state, 3), d)}};

	return t;
}

/* A corner of b at a corner, on an edge, or on the face of a (its edges divisible by 4), perhaps beside it. */
static inline void make_grazing(uint64_t *state, int m, itri *a, itri *b)
{
	ivec p = random_ivec(state, m / 8), d = random_ivec(state, m / 16), e = random_ivec(state, m / 16);

	*a = (itri){{p, imad(p, 4, d), imad(p, 4, e)}};
	*b = random_itri(state, m);
	b->p[0] = imad(imad(p, 1 + random_int(state, 1), d), 1 + random_int(state, 1), e);
	if (random_int(state, 1) > 0)
		b->p[0] = imad(b->p[0], 1, random_ivec(state, 1));
	if (random_int(state, 1) > 0)
		b->p[1] = imad(b->p[0], -1, isub(b->p[1], b->p[0]));
}

static inline void make_coplanar(uint64_t *state, int m, itri *a, itri *b)
{
	ivec u = random_ivec(state, m > 64 ? m / 64 : 1), v = random_ivec(state, m > 64 ? m / 64 : 1);
	ivec origin = random_ivec(state, m / 4);

	for (int k = 0; k < 6; k++) {
		ivec p = imad(imad(origin, random_int(state, 16), u), random_int(state, 16), v);

		*(k < 3 ? &a->p[k] : &b->p[k - 3]) = p;
	}
}

/* Two vectors of the lattice of u and v, up to m long, that span one cell: sin is of the order of 1 / m^2. */
static inline void neighbours(uint64_t *state, int m, ivec *d, ivec *e)
{
	ivec u = random_ivec(state, 1), v = random_ivec(state, 1);

	for (int k = 0; k < 60; k++) {
		ivec sum = imad(u, 1, v);

		if (idot(sum, sum) > (wide)m * m)
			break;
		*(random_int(state, 1) > 0 ? &u : &v) = sum;
	}
	*d = u;
	*e = v;
}

static inline void make_lattice(uint64_t *state, int m, itri *a, itri *b)
{
	ivec d, e, p = random_ivec(state, m / 8), high = random_ivec(state, random_int(state, 1) ? 3 : m / 4);
	ivec apex = random_ivec(state, m / 2);

	neighbours(state, m / 2, &d, &e);
	if (random_int(state, 1) > 0) {
		/* Two long edges that cross, in space or really. */
		*a = (itri){{p, imad(p, 1, d), apex}};
		p = imad(p, random_int(state, 1), high);
		*b = (itri){{p, imad(p, 1, e), random_ivec(state, m)}};
		return;
	}
	*a = (itri){{p, imad(p, 1, d), imad(p, random_int(state, 1), e)}};
	*b = random_itri(state, m);
	b->p[0] = imad(imad(p, random_int(state, 1) > 0, d), 1, high);
	if (random_int(state, 1) > 0)
		b->p[1] = imad(imad(p, random_int(state, 1) > 0, e), -1, high);
}

static inline void make_pair(enum kind kind, uint64_t *state, int m, itri *a, itri *b)
{
	*a = kind == NEEDLES ? needle(state, m) : kind == CAPS ? cap(state, m) : random_itri(state, m);
	*b = random_itri(state, m);
	switch (kind) {
	case COPLANAR:
		make_coplanar(state, m, a, b);
		break;
	case SHARED_CORNER:
		b->p[random_int(state, 1) + 1] = a->p[random_int(state, 1) + 1];
		break;
	case SHARED_EDGE:
		b->p[0] = a->p[2];
		b->p[1] = a->p[0];
		break;
	case NEEDLES:
		*b = random_int(state, 1) ? needle(state, m) : *b;
		break;
	case CAPS:
		*b = random_int(state, 1) ? cap(state, m) : *b;
		break;
	case PARALLEL_EDGES:
		b->p[0] = imad(a->p[0], 1, random_ivec(state, random_int(state, 1) ? 2 : m));
		b->p[1] = imad(imad(b->p[0], 1, iedge(a, 0)), 1, random_ivec(state, 2));
		break;
	case LATTICE:
		make_lattice(state, m, a, b);
		break;
	case DEGENERATE:
		*a = degenerate(state, m);
		*b = random_int(state, 1) ? degenerate(state, m) : *b;
		break;
	case GRAZING:
		make_grazing(state, m, a, b);
		break;
	default:
		break;
	}
}

/* Magnitudes: up to 5/4 m. */
static inline void random_pair(int turn, uint64_t *state, int m, itri *a, itri *b)
{
	enum kind kind = (enum kind)(turn % KINDS);

	make_pair(kind, state, kind == TINY_GRID ? 3 : m, a, b);
	if (turn / KINDS % 2) {
		itri swap = *a;

		*a = *b;
		*b = swap;
	}
}

#endif
