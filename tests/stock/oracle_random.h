/* oracle_random.h - the random numbers of a job: the same seed makes the same job. */
#ifndef ORACLE_RANDOM_H
#define ORACLE_RANDOM_H

#include <math.h>

struct oracle_random {
	unsigned long long state;
};

static inline double uniform(struct oracle_random *random, double low, double high)
{
	random->state = random->state * 6364136223846793005ULL + 1442695040888963407ULL;
	return low + (high - low) * (double)(random->state >> 11) / 9007199254740992.0;
}

static inline struct oracle_random oracle_random_of(long seed)
{
	struct oracle_random random = {(unsigned long long)seed * 2654435761ULL + 12345};

	uniform(&random, 0, 1);
	return random;
}

/* Numbers are written with so many digits, so that both sides have the same. */
static inline double rounded(double x)
{
	return round(x * 1000) / 1000;
}

#endif
