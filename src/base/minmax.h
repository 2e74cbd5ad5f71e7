/* minmax.h - fmin and fmax for numbers that are not NaN: two instructions instead of a call. */
#ifndef FIVECHECK_BASE_MINMAX_H
#define FIVECHECK_BASE_MINMAX_H

/* With a NaN the result is the second argument. */
static inline double smaller(double a, double b)
{
	return a < b ? a : b;
}

static inline double larger(double a, double b)
{
	return a > b ? a : b;
}

#endif
