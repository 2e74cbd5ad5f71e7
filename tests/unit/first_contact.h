/* first_contact.h - when two bodies first touch along a straight move, by brute force: the measure of sweeps. */
#ifndef FIVECHECK_TESTS_FIRST_CONTACT_H
#define FIVECHECK_TESTS_FIRST_CONTACT_H

#include "scene/sweep.h"
#include "solids.h"

/*
 * All pairs of triangles, halving the motion wherever the distance at its
 * middle does not exceed what the joints can do to it: first order only, no trees,
 * no axes. Motions of less than `least_way` mm are looked at in three instants.
 */
struct oracle {
	const struct duo *duo;
	const axis_values *q0, *q1;
	double clearance, least_way;
	struct centred_tri *of_a;
	long steps;
};

struct oracle_pair {
	uint32_t i, j;
};

/* mm per unit of s that a point of b can move at s, plus what can change within `half` of it. */
static inline double oracle_speed(const struct oracle *o, double s, double half)
{
	const struct chain *chain = &o->duo->chain;
	const struct ball *ball = &o->duo->pair.ball_b;
	real3 at = real3_of(ball->centre);
	double speed = 0;

	for (size_t i = chain->count; i-- > 0;) {
		const struct joint *joint = &chain->joints[i];
		double q0 = o->q0->v[joint->slot], q1 = o->q1->v[joint->slot], rate = fabs(q1 - q0);
		struct turned t = turned_joint(joint, (1 - (real)s) * q0 + (real)s * q1);
		real3 to = real3_sub(at, real3_of(joint->location));

		if (joint->rotary)
			rate *= (double)real3_norm(real3_cross(to, real3_of(joint->direction))) + ball->radius +
				half * speed;
		speed += rate;
		at = turned_apply(&t, at);
	}
	return speed * (1 + 1e-12);
}

static inline struct centred_tri oracle_tri(const struct oracle *o, const xform *pose, uint32_t j)
{
	tri t = tri_of(&o->duo->b->mesh, j);

	return centred(tri_transform(&t, pose));
}

/* Is the pair farther apart than `most`? */
static inline bool oracle_apart(const struct centred_tri *a, const struct centred_tri *b, double most)
{
	double reach = most + a->radius + b->radius;

	if (vec3_norm2(vec3_sub(a->centre, b->centre)) > reach * reach)
		return true;
	/* Most pairs are decided by bounds, which take a hundredth of the time. */
	return !surely_within(a, b, most) && (gap_between(a, b) > most || true_distance(&a->t, &b->t) > most);
}

/* Touches at s? */
static inline bool oracle_touches(const struct oracle *o, const struct oracle_pair *pairs, size_t count, double s)
{
	xform pose = duo_pose(o->duo, o->q0, o->q1, s, NULL);

	for (size_t k = 0; k < count; k++) {
		struct centred_tri b = oracle_tri(o, &pose, pairs[k].j);

		if (!oracle_apart(&o->of_a[pairs[k].i], &b, o->clearance))
			return true;
	}
	return false;
}

static inline double oracle_search(struct oracle *o, double s0, double s1, const struct oracle_pair *pairs,
				   size_t count)
{
	double middle = 0.5 * (s0 + s1), half = 0.5 * (s1 - s0), way = half * oracle_speed(o, middle, half);
	xform pose = duo_pose(o->duo, o->q0, o->q1, middle, NULL);
	struct oracle_pair *kept = mem_alloc((count + 1) * sizeof(*kept));
	struct centred_tri b = {0};
	size_t left = 0;
	double found = INFINITY;

	o->steps++;
	for (size_t k = 0; k < count; k++) {
		if (!k || pairs[k].j != pairs[k - 1].j)
			b = oracle_tri(o, &pose, pairs[k].j);
		if (!oracle_apart(&o->of_a[pairs[k].i], &b, o->clearance + way))
			kept[left++] = pairs[k];
	}
	if (left && 2 * way > o->least_way) {
		found = oracle_search(o, s0, middle, kept, left);
		if (!(found < INFINITY))
			found = oracle_search(o, middle, s1, kept, left);
	} else if (left) {
		const double instants[3] = {s0, middle, s1};

		for (int k = 0; k < 3 && !(found < INFINITY); k++)
			if (oracle_touches(o, kept, left, instants[k]))
				found = instants[k];
	}
	free(kept);
	return found;
}

/* The first s at which the distance is at most the clearance; INFINITY: none found. */
static inline double oracle_first(const struct duo *duo, const axis_values *q0, const axis_values *q1, double clearance,
				  double least_way)
{
	size_t na = duo->a->mesh.count, nb = duo->b->mesh.count;
	struct oracle o = {duo, q0, q1, clearance, least_way, mem_alloc(na * sizeof(struct centred_tri)), 0};
	struct oracle_pair *pairs = mem_alloc(na * nb * sizeof(*pairs));
	double first;

	for (size_t i = 0; i < na; i++)
		o.of_a[i] = centred(tri_of(&duo->a->mesh, i));
	for (size_t k = 0; k < na * nb; k++)
		pairs[k] = (struct oracle_pair){(uint32_t)(k % na), (uint32_t)(k / na)};
	first = oracle_search(&o, 0, 1, pairs, na * nb);
	free(pairs);
	free(o.of_a);
	return first;
}

/* mm: how far corners move between two instants, in the better of both views. */
static inline double oracle_motion(const struct duo *duo, const axis_values *q0, const axis_values *q1, double s,
				   double t)
{
	xform poses[2] = {duo_pose(duo, q0, q1, s, NULL), duo_pose(duo, q0, q1, t, NULL)};
	const struct mesh *meshes[2] = {&duo->b->mesh, &duo->a->mesh};
	double most[2] = {0, 0};

	for (int view = 0; view < 2; view++) {
		for (size_t i = 0; i < meshes[view]->count; i++) {
			for (int k = 0; k < 3; k++) {
				vec3 p = mesh_corner(&meshes[view]->triangles[i], k);

				most[view] =
				    fmax(most[view],
					 vec3_norm(vec3_sub(xform_apply(&poses[0], p), xform_apply(&poses[1], p))));
			}
		}
		poses[0] = xform_inverse(&poses[0]);
		poses[1] = xform_inverse(&poses[1]);
	}
	return fmin(most[0], most[1]);
}

/* Judges a sweep's answer; `what` and `number` name the case in a complaint. Returns the oracle's instant. */
static inline double oracle_judge(const struct duo *duo, const axis_values *q0, const axis_values *q1, double clearance,
				  double tolerance, enum sweep_answer answer, const struct contact *contact,
				  const char *what, long number)
{
	double first = oracle_first(duo, q0, q1, clearance, tolerance / 16), distance;
	xform pose;

	require(answer != SWEEP_UNDECIDED, "%s, case %ld: undecided", what, number);
	if (answer == SWEEP_APART) {
		require(!(first < INFINITY), "%s, case %ld: called apart, contact at %.12g", what, number, first);
		return first;
	}
	require(contact->s >= 0 && contact->s <= 1, "%s, case %ld: s = %g", what, number, contact->s);
	pose = duo_pose(duo, q0, q1, contact->s, NULL);
	distance = brute_distance(duo->a, duo->b, &pose, INFINITY);
	require(distance <= clearance + tolerance + 1e-9,
		"%s, case %ld: false alarm at %.12g: %.9g apart, clearance %.9g", what, number, contact->s, distance,
		clearance);
	require(contact->distance <= clearance + tolerance + 1e-9 && contact->distance >= distance - 1e-9,
		"%s, case %ld: distance given as %.9g, is %.9g", what, number, contact->distance, distance);
	for (size_t i = 0; i < duo->chain.count; i++) {
		int slot = duo->chain.joints[i].slot;
		double q = (1 - contact->s) * q0->v[slot] + contact->s * q1->v[slot];

		require(fabs(contact->q.v[slot] - q) <= 1e-12 * (fabs(q0->v[slot]) + fabs(q1->v[slot]) + 1),
			"%s, case %ld: position of %d", what, number, slot);
	}
	if (first < contact->s)
		require(oracle_motion(duo, q0, q1, first, contact->s) <= tolerance + 1e-9,
			"%s, case %ld: contact given at %.12g, but %.12g is %g mm earlier", what, number, contact->s,
			first, oracle_motion(duo, q0, q1, first, contact->s));
	return first;
}

#endif
