#include "base/math/double_double.h"
#include "base/math/math_functions.h"

#include <math.h>

/* Squares of numbers between these are exact in two doubles, and do not overflow. */
#define LARGE 0x1p500
#define SMALL 0x1p-400
#define SCALING 600

/* For a >= b > 0 with b not below 2^-61 a. */
static dd length(double a, double b)
{
	const dd aa = two_product(a, a), bb = two_product(b, b), sum = quick_two_sum(aa.hi, bb.hi);
	const double root = sqrt(sum.hi);
	const dd again = two_product(root, root);

	return (dd){root, (((sum.hi - again.hi) - again.lo) + (sum.lo + (aa.lo + bb.lo))) / (2 * root)};
}

double math_hypot(double x, double y)
{
	const double a = fmax(fabs(x), fabs(y)), b = fmin(fabs(x), fabs(y));
	dd sum;

	if (isinf(x) || isinf(y))
		return INFINITY;
	if (isnan(x) || isnan(y))
		return x + y;
	if (b <= a * 0x1p-60)
		return a;
	if (a < LARGE && b > SMALL) {
		sum = length(a, b);
		return sum.hi + sum.lo;
	}
	if (a >= LARGE)
		return dd_scaled(length(a * power_of_two(-SCALING), b * power_of_two(-SCALING)), SCALING);
	return dd_scaled(length(a * power_of_two(SCALING), b * power_of_two(SCALING)), -SCALING);
}
