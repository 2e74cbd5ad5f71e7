/* truth.h - kinematics and distances for comparison, computed again in long double and by other formulas. */
#ifndef FIVECHECK_TESTS_TRUTH_H
#define FIVECHECK_TESTS_TRUTH_H

#include <math.h>
#include <stdbool.h>

#include "geom/tri.h"
#include "machine/chain.h"
#include "random.h"

typedef long double real;

typedef struct real3 {
	real x, y, z;
} real3;

static inline real3 real3_of(vec3 a)
{
	return (real3){a.x, a.y, a.z};
}

static inline vec3 real3_round(real3 a)
{
	return (vec3){(double)a.x, (double)a.y, (double)a.z};
}

static inline real3 real3_add(real3 a, real3 b)
{
	return (real3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline real3 real3_sub(real3 a, real3 b)
{
	return (real3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline real3 real3_scale(real s, real3 a)
{
	return (real3){s * a.x, s * a.y, s * a.z};
}

static inline real real3_dot(real3 a, real3 b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline real3 real3_cross(real3 a, real3 b)
{
	return (real3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline real real3_norm(real3 a)
{
	return sqrtl(real3_dot(a, a));
}

/* ------------------------------------------------------------- kinematics */

/* The unit quaternion (w, v) rotates a point, then `shift` is added. */
struct turned {
	real w;
	real3 v;
	real3 shift;
};

static inline real3 turned_direction(const struct turned *t, real3 p)
{
	real3 c = real3_scale(2, real3_cross(t->v, p));

	return real3_add(real3_add(p, real3_scale(t->w, c)), real3_cross(t->v, c));
}

static inline real3 turned_apply(const struct turned *t, real3 p)
{
	return real3_add(turned_direction(t, p), t->shift);
}

static inline real3 turned_back(const struct turned *t, real3 p)
{
	struct turned inverse = {t->w, real3_scale(-1, t->v), {0, 0, 0}};

	return turned_direction(&inverse, real3_sub(p, t->shift));
}

/* first b, then a */
static inline struct turned turned_mul(const struct turned *a, const struct turned *b)
{
	real3 v = real3_add(real3_add(real3_scale(a->w, b->v), real3_scale(b->w, a->v)), real3_cross(a->v, b->v));

	return (struct turned){a->w * b->w - real3_dot(a->v, b->v), v, turned_apply(a, b->shift)};
}

static inline struct turned turned_identity(void)
{
	return (struct turned){1, {0, 0, 0}, {0, 0, 0}};
}

static inline struct turned turned_joint(const struct joint *joint, real value)
{
	real3 d = real3_of(joint->direction), at = real3_of(joint->location);
	struct turned t = turned_identity();

	if (!joint->rotary) {
		t.shift = real3_scale(value, d);
		return t;
	}
	t.w = cosl(value / 2);
	t.v = real3_scale(sinl(value / 2), d);
	t.shift = real3_sub(at, turned_direction(&t, at));
	return t;
}

/* The pose of the moved link at (1-s) q0 + s q1 + off; off may be NULL. */
static inline struct turned true_pose(const struct chain *chain, const axis_values *q0, const axis_values *q1, real s,
				      const axis_values *off)
{
	struct turned pose = turned_identity();

	for (size_t i = 0; i < chain->count; i++) {
		int slot = chain->joints[i].slot;
		real value = (1 - s) * q0->v[slot] + s * q1->v[slot] + (off ? off->v[slot] : 0);
		struct turned joint = turned_joint(&chain->joints[i], value);

		pose = turned_mul(&pose, &joint);
	}
	return pose;
}

/* place_a^-1 pose place_b, as a body_pair has it. */
static inline xform true_mesh_pose(const struct turned *pose, const xform *place_a, const xform *place_b)
{
	const vec3 units[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
	real3 images[4];

	for (int i = 0; i < 4; i++) {
		const mat3 *m = &place_b->rotation, *n = &place_a->rotation;
		real3 p = real3_of(units[i]), q;

		q = real3_add(real3_add(real3_scale(p.x, real3_of(m->x)), real3_scale(p.y, real3_of(m->y))),
			      real3_scale(p.z, real3_of(m->z)));
		q = turned_apply(pose, real3_add(q, real3_of(place_b->translation)));
		q = real3_sub(q, real3_of(place_a->translation));
		images[i] = (real3){real3_dot(real3_of(n->x), q), real3_dot(real3_of(n->y), q),
				    real3_dot(real3_of(n->z), q)};
	}
	return (xform){{real3_round(real3_sub(images[1], images[0])), real3_round(real3_sub(images[2], images[0])),
			real3_round(real3_sub(images[3], images[0]))},
		       real3_round(images[0])};
}

/* ----------------------------------------------------------------- chains */

/* `count` joints in any order and direction, each with its own slot, within `span` mm of the origin. */
static inline struct chain random_chain(struct random *random, int count, double span)
{
	struct chain chain = {.count = (size_t)count};
	int slots[SLOT_COUNT] = {0};

	for (int i = 0; i < SLOT_COUNT; i++) {
		int j = random_below(random, i + 1);

		slots[i] = slots[j];
		slots[j] = i;
	}
	for (int i = 0; i < count; i++) {
		struct joint *joint = &chain.joints[i];
		const vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
		vec3 direction = vec3_scale(random_sign(random), axes[random_below(random, 3)]);

		*joint = (struct joint){slots[i], random_below(random, 2), direction, random_point(random, span)};
		if (random_below(random, 2))
			joint->direction = random_unit(random);
	}
	return chain;
}

/* Positions and a move of at most about `way` mm or way/100 radians per joint. */
static inline void random_move(struct random *random, const struct chain *chain, double way, axis_values *q0,
			       axis_values *q1)
{
	*q0 = *q1 = (axis_values){{0}};
	for (size_t i = 0; i < chain->count; i++) {
		const struct joint *joint = &chain->joints[i];
		double step = random_sign(random) * random_size(random, 1e-3, 1) * way * (joint->rotary ? 0.01 : 1);

		if (!random_below(random, 4))
			step = 0;
		q0->v[joint->slot] = random_in(random, -1, 1) * (joint->rotary ? PI : 200);
		q1->v[joint->slot] = q0->v[joint->slot] + step;
	}
}

/* --------------------------------------------------------------- distance */

static inline real clamp01(real s)
{
	return s < 0 ? 0 : s > 1 ? 1 : s;
}

static inline real least(real a, real b)
{
	return b < a ? b : a;
}

/*
 * The square of the least of the four distances from an end to a segment and, if its feet are in both, that of the
 * common perpendicular.
 */
static inline real true_segments2(const real3 p[2], const real3 q[2])
{
	real3 d = real3_sub(p[1], p[0]), e = real3_sub(q[1], q[0]), n = real3_cross(d, e), r = real3_sub(q[0], p[0]);
	real dd = real3_dot(d, d), ee = real3_dot(e, e), nn = real3_dot(n, n), best = INFINITY;

	for (int i = 0; i < 2; i++) {
		real t = ee > 0 ? clamp01(real3_dot(real3_sub(p[i], q[0]), e) / ee) : 0;
		real s = dd > 0 ? clamp01(real3_dot(real3_sub(q[i], p[0]), d) / dd) : 0;
		real3 from_p = real3_sub(real3_add(q[0], real3_scale(t, e)), p[i]);
		real3 from_q = real3_sub(real3_add(p[0], real3_scale(s, d)), q[i]);

		best = least(best, least(real3_dot(from_p, from_p), real3_dot(from_q, from_q)));
	}
	if (nn > 1e-24L * dd * ee) {
		real s = real3_dot(real3_cross(r, e), n) / nn, t = real3_dot(real3_cross(r, d), n) / nn;
		real along = real3_dot(r, n);

		if (s >= 0 && s <= 1 && t >= 0 && t <= 1)
			best = least(best, along * along / nn);
	}
	return best;
}

/* Is the foot of x in the triangle with the normal n? */
static inline bool true_over_face(const real3 t[3], real3 n, real3 x)
{
	if (!(real3_dot(n, n) > 0))
		return false;
	for (int i = 0; i < 3; i++) {
		real3 edge = real3_sub(t[(i + 1) % 3], t[i]);

		if (real3_dot(real3_cross(edge, real3_sub(x, t[i])), n) < 0)
			return false;
	}
	return true;
}

/* Does the segment from p, h0 over the plane of the triangle with the normal n, to q, h1 over it, pass through the triangle? */
static inline bool true_pierces(const real3 t[3], real3 n, real3 p, real h0, real3 q, real h1)
{
	if ((h0 > 0 && h1 > 0) || (h0 < 0 && h1 < 0) || !(fabsl(h0 - h1) > 0))
		return false;
	return true_over_face(t, n, real3_add(p, real3_scale(h0 / (h0 - h1), real3_sub(q, p))));
}

/* All features: nine pairs of edges, six corners over faces, six edges through faces. */
static inline double true_distance(const tri *a, const tri *b)
{
	real3 t[2][3];
	real best = INFINITY;

	for (int i = 0; i < 3; i++) {
		t[0][i] = real3_of(a->p[i]);
		t[1][i] = real3_of(b->p[i]);
	}
	for (int i = 0; i < 3; i++) {
		for (int j = 0; j < 3; j++) {
			const real3 p[2] = {t[0][i], t[0][(i + 1) % 3]}, q[2] = {t[1][j], t[1][(j + 1) % 3]};

			best = least(best, true_segments2(p, q));
		}
	}
	for (int k = 0; k < 2; k++) {
		const real3 *face = t[k], *other = t[1 - k];
		const real3 n = real3_cross(real3_sub(face[1], face[0]), real3_sub(face[2], face[0]));
		real h[3];

		for (int i = 0; i < 3; i++)
			h[i] = real3_dot(n, real3_sub(other[i], face[0]));
		for (int i = 0; i < 3; i++) {
			const int to = (i + 1) % 3;

			if (true_over_face(face, n, other[i]))
				best = least(best, h[i] * h[i] / real3_dot(n, n));
			if (true_pierces(face, n, other[i], h[i], other[to], h[to]))
				return 0;
		}
	}
	return (double)sqrtl(best);
}

#endif
