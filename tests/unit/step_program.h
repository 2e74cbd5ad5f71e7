/* step_program.h - two random solids near each other, and a program of short straight steps that moves them: for tests. */
#ifndef FIVECHECK_TESTS_STEP_PROGRAM_H
#define FIVECHECK_TESTS_STEP_PROGRAM_H

#include "motion/motion.h"
#include "motion/path.h"
#include "motion/span.h"
#include "solids.h"

enum { STEPS = 40 };

/* Two solids and a program of short straight steps. */
struct program {
	struct random random;
	struct duo duo;
	double clearance, tolerance;
	axis_values corners[STEPS + 1];
};

static inline void program_init(struct program *p, uint64_t test, long number)
{
	struct random *random = &p->random;
	struct chain chain;
	struct mesh a, b;
	xform place_a, place_b;
	double size, step;

	*p = (struct program){.random = random_case(test, number)};
	chain = random_chain(random, 1 + random_below(random, 5), 200);
	random_move(random, &chain, 0.001, &p->corners[0], &p->corners[1]);
	size = random_size(random, 2, 60);
	a = random_solid(random, size);
	b = random_solid(random, size);
	place_a = random_place(random, 200);
	place_b = place_near(random, &chain, &p->corners[0], &place_a,
			     vec3_scale(size * random_in(random, 1.5, 3), random_unit(random)));
	duo_init(&p->duo, &chain, &a, &b, &place_a, &place_b);
	p->clearance = random_below(random, 2) ? 0 : random_size(random, 1e-3, 5);
	p->tolerance = random_below(random, 3) ? 1e-3 : random_size(random, 1e-5, 0.1);
	step = random_size(random, 1e-2, 20);
	for (int i = 1; i <= STEPS; i++) {
		p->corners[i] = p->corners[i - 1];
		for (size_t k = 0; k < chain.count; k++)
			if (random_below(random, 3))
				p->corners[i].v[chain.joints[k].slot] +=
					step * (chain.joints[k].rotary ? 0.01 : 1) * random_in(random, -1, 1);
	}
}

static inline struct path path_between(const axis_values *q0, const axis_values *q1, enum path_kind kind)
{
	return (struct path){.kind = kind, .start = *q0, .end = *q1, .seconds = 1};
}

static inline struct motion_step step_on(const struct path *path)
{
	struct motion_step step = {.line = 1, .move = 1, .seconds = 1};

	span_init(&step.span, path);
	return step;
}

#endif
