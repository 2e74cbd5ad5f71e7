/* scene_of_two.h - for the tests of planes: two random solids on a random chain, and random motions of them. */
#ifndef FIVECHECK_TESTS_SCENE_OF_TWO_H
#define FIVECHECK_TESTS_SCENE_OF_TWO_H

#include "check/certified/travelling_plane.h"
#include "solids.h"

/* Two solids on a random chain, which stand at `at`. */
struct scene_of_two {
	struct random random;
	struct duo duo;
	axis_values at;
	double size;
};

static inline void scene_init(struct scene_of_two *s, uint64_t test, long number)
{
	struct random *random = &s->random;
	struct chain chain;
	struct mesh a, b;
	xform place_a, place_b;
	axis_values other;

	s->random = random_case(test, number);
	chain = random_chain(random, 1 + random_below(random, 6), 200);
	random_move(random, &chain, 0.001, &s->at, &other);
	/* Some machines wind on without end. */
	if (!random_below(random, 4))
		for (size_t i = 0; i < chain.count; i++)
			s->at.v[chain.joints[i].slot] += chain.joints[i].rotary ? random_in(random, -400, 400) : 0;
	s->size = random_size(random, 2, 60);
	a = random_solid(random, s->size);
	b = random_solid(random, s->size);
	place_a = random_place(random, 200);
	place_b = place_near(random, &chain, &s->at, &place_a,
			     vec3_scale(s->size * random_in(random, 1, 4), random_unit(random)));
	duo_init(&s->duo, &chain, &a, &b, &place_a, &place_b);
}

/* Straight or a box, with chord errors or without; long or short. */
static inline struct plane_motion random_motion(struct scene_of_two *s)
{
	struct random *random = &s->random;
	struct plane_motion motion = {.straight = random_below(random, 2), .q0 = s->at, .q1 = s->at};
	double step = random_size(random, 1e-3, 100);
	bool strays = !random_below(random, 3), ordered = !motion.straight;

	for (size_t i = 0; i < s->duo.chain.count; i++) {
		const struct joint *joint = &s->duo.chain.joints[i];
		double unit = step * (joint->rotary ? 0.01 : 1);
		double *q0 = &motion.q0.v[joint->slot], *q1 = &motion.q1.v[joint->slot];

		*q0 += random_below(random, 3) ? unit * random_in(random, -1, 1) : 0;
		*q1 += random_below(random, 3) ? unit * random_in(random, -1, 1) : 0;
		if (ordered && *q0 > *q1) {
			double keep = *q0;

			*q0 = *q1;
			*q1 = keep;
		}
		if (strays)
			motion.chord_error.v[joint->slot] = random_size(random, 1e-4, 0.1) * unit;
	}
	return motion;
}

/* A position of the motion, often at its edge. */
static inline axis_values random_position(struct scene_of_two *s, const struct plane_motion *motion)
{
	struct random *random = &s->random;
	double along = random_below(random, 2) ? random_below(random, 2) : random_in(random, 0, 1);
	axis_values q;

	for (int k = 0; k < SLOT_COUNT; k++) {
		double share = motion->straight		 ? along
			       : random_below(random, 2) ? random_below(random, 2)
							 : random_in(random, 0, 1);
		double off = random_below(random, 2) ? random_sign(random) : random_in(random, -1, 1);

		q.v[k] = (1 - share) * motion->q0.v[k] + share * motion->q1.v[k] + off * motion->chord_error.v[k];
	}
	return q;
}

#endif
