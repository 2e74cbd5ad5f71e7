/* same_double.h - exact comparison of two doubles, for values that were copied and not computed. */
#ifndef FIVECHECK_BASE_SAME_DOUBLE_H
#define FIVECHECK_BASE_SAME_DOUBLE_H

#include <stdbool.h>

/*
 * Neither is NaN. Compilers warn about == between doubles because computed values that should be equal rarely are. Here
 * exactness is meant: the value that was stored before, a word that is 0, an axis that did not move at all.
 */
static inline bool same_double(double a, double b)
{
	return !(a < b || a > b);
}

#endif
