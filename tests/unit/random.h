/* random.h - repeatable random numbers for tests: every case has a seed of its own, which a failure names. */
#ifndef FIVECHECK_TESTS_RANDOM_H
#define FIVECHECK_TESTS_RANDOM_H

#include <check.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/units.h"
#include "geom/xform.h"

/* ck_assert_msg tells its parent of every pass, which takes longer than most of what is tested by the million. */
#define require(condition, ...) \
	do { \
		if (!(condition)) \
			ck_abort_msg(__VA_ARGS__); \
	} while (0)

/* Steele, Lea and Flood, "Fast splittable pseudorandom number generators" (splitmix64). */
struct random {
	uint64_t state;
};

static inline uint64_t random_bits(struct random *random)
{
	uint64_t z = random->state += UINT64_C(0x9e3779b97f4a7c15);

	z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
	z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
	return z ^ z >> 31;
}

/* FIVECHECK_SEED in the environment shifts all cases. */
static inline struct random random_case(uint64_t test, long number)
{
	const char *shift = getenv("FIVECHECK_SEED");
	struct random random = {(shift ? strtoull(shift, NULL, 0) : 0) * UINT64_C(0x2545f4914f6cdd1d) + test};

	random.state = random_bits(&random) + (uint64_t)number * UINT64_C(0xd1342543de82ef95);
	random_bits(&random);
	return random;
}

/* How many cases to run: FIVECHECK_CASES in the environment multiplies the usual number. */
static inline long random_cases(long usual)
{
	const char *factor = getenv("FIVECHECK_CASES");
	double wanted = factor ? strtod(factor, NULL) : 1;

	return wanted > 0 ? (long)ceil((double)usual * wanted) : usual;
}

static inline double random_in(struct random *random, double least, double most)
{
	return least + (most - least) * ((double)(random_bits(random) >> 11) * 0x1p-53);
}

static inline int random_below(struct random *random, int count)
{
	return (int)(random_bits(random) % (uint64_t)count);
}

/* All orders of magnitude alike; 0 < least. */
static inline double random_size(struct random *random, double least, double most)
{
	return exp(random_in(random, log(least), log(most)));
}

static inline double random_sign(struct random *random)
{
	return random_below(random, 2) ? 1 : -1;
}

static inline vec3 random_point(struct random *random, double size)
{
	/* One after the other: compilers differ in the order within one expression. */
	double x = random_in(random, -size, size), y = random_in(random, -size, size);

	return (vec3){x, y, random_in(random, -size, size)};
}

static inline vec3 random_unit(struct random *random)
{
	for (;;) {
		vec3 v = random_point(random, 1);
		double norm = vec3_norm(v);

		if (norm > 0.1 && norm <= 1)
			return vec3_scale(1 / norm, v);
	}
}

static inline xform random_place(struct random *random, double size)
{
	xform place = xform_turn((vec3){0, 0, 0}, random_unit(random), random_in(random, -PI, PI));

	place.translation = random_point(random, size);
	return place;
}

#endif
