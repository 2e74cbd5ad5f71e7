/*
 * test_math.c - the elementary functions: exact values, special values, the C library's long doubles, and fixed bits.
 * make check-math compares them with MPFR.
 */
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/math/math_functions.h"
#include "random.h"
#include "suite.h"

#define same(got, wanted) ck_assert_msg(same_bits(got, wanted), "%s: %a, not %a", #got, got, (double)(wanted))

static bool same_bits(double a, double b)
{
	return (isnan(a) && isnan(b)) || memcmp(&a, &b, sizeof(a)) == 0;
}

START_TEST(angles_in_degrees_are_exact)
{
	for (int turn = -3; turn <= 3; turn++) {
		const double at = 360.0 * turn;

		same(math_cos_degrees(at + 60), 0.5);
		same(math_cos_degrees(at + 90), 0.0);
		same(math_cos_degrees(at + 180), -1.0);
		same(math_sin_degrees(at + 30), 0.5);
		same(math_sin_degrees(at + 180), 0.0);
		same(math_sin_degrees(at + 270), -1.0);
		same(math_tan_degrees(at + 45), 1.0);
		same(math_tan_degrees(at + 135), -1.0);
	}
	same(math_tan_degrees(90), INFINITY);
	same(math_sin_degrees(1e300), math_sin_degrees(fmod(1e300, 360)));
	same(math_asin_degrees(0.5), 30.0);
	same(math_asin_degrees(-1), -90.0);
	same(math_acos_degrees(0.5), 60.0);
	same(math_acos_degrees(-0.5), 120.0);
	same(math_acos_degrees(0), 90.0);
	same(math_acos_degrees(-1), 180.0);
	same(math_atan2_degrees(7, 7), 45.0);
	same(math_atan2_degrees(-7, -7), -135.0);
	same(math_atan2_degrees(1e-300, -1), 180.0);
	same(math_atan2_degrees(3, 0), 90.0);
}
END_TEST

START_TEST(known_values)
{
	double power = 1;

	same(math_sin(0), 0.0);
	same(math_cos(0), 1.0);
	same(math_sin(PI / 2), 1.0);
	same(math_cos(PI), -1.0);
	/* The difference of PI from pi; and the hardest argument reduction of all doubles. */
	same(math_sin(PI), 0x1.1a62633145c07p-53);
	same(math_cos(PI / 2), 0x1.1a62633145c07p-54);
	same(math_cos(0x1.6ac5b262ca1ffp849), -0x1.14ae72e6ba22fp-61);
	same(math_atan2(1, 1), PI / 4);
	same(math_acos(-1), PI);
	same(math_asin(1), PI / 2);
	same(math_exp(0), 1.0);
	same(math_exp(1), 0x1.5bf0a8b145769p1);
	same(math_log(1), 0.0);
	for (int n = -300; n <= 300; n++)
		same(math_log10(strtod((char[]){'1', 'e', n < 0 ? '-' : '+', (char)('0' + abs(n) / 100),
						(char)('0' + abs(n) / 10 % 10), (char)('0' + abs(n) % 10), '\0'}, NULL)),
		     (double)n);
	for (int n = -1074; n <= 1023; n++)
		same(math_pow(2, n), ldexp(1, n));
	for (int n = 0; n <= 22; n++, power *= -10)
		same(math_pow(-10, n), power);
	same(math_hypot(3, 4), 5.0);
	same(math_hypot(-3 * 0x1p700, 4 * 0x1p700), 5 * 0x1p700);
	same(math_hypot(3 * 0x1p-1074, 4 * 0x1p-1074), 5 * 0x1p-1074);
}
END_TEST

START_TEST(special_values)
{
	const double signs[] = {1, -1};

	for (int i = 0; i < 2; i++) {
		const double s = signs[i], zero = s * 0.0, infinite = s * INFINITY, least = s * 0x1p-1074;

		same(math_sin(zero), zero);
		same(math_tan(zero), zero);
		same(math_asin(zero), zero);
		same(math_sin_degrees(zero), zero);
		same(math_cos(zero), 1.0);
		same(math_sin(least), least);
		same(math_asin(least), least);
		same(math_sin(infinite), NAN);
		same(math_cos_degrees(infinite), NAN);
		same(math_tan(infinite), NAN);
		same(math_atan2(zero, 1), zero);
		same(math_atan2(zero, 0.0), zero);
		same(math_atan2(least, DBL_MAX), zero);
		same(math_atan2(least, 1), least);
		same(math_atan2_degrees(least, DBL_MAX), zero);
		same(math_atan2_degrees(s * 0x1p-1022, 0x1p50), s * 0xe5p-1074);
		same(math_sin_degrees(s * 0x1p-1070), zero);
		same(math_exp(-745.1), 0x1p-1074);
		same(math_exp(-750), 0.0);
		same(math_atan2(zero, -0.0), s * PI);
		same(math_atan2(zero, -1), s * PI);
		same(math_atan2(s, 0), s * PI / 2);
		same(math_atan2(infinite, INFINITY), s * PI / 4);
		same(math_atan2(infinite, -INFINITY), s * 3 * PI / 4);
		same(math_atan2(s, INFINITY), zero);
		same(math_atan2(s, -INFINITY), s * PI);
		same(math_atan2(infinite, 1), s * PI / 2);
		same(math_hypot(infinite, NAN), INFINITY);
		same(math_hypot(zero, 0), 0.0);
		same(math_pow(NAN, zero), 1.0);
		same(math_pow(1, infinite), 1.0);
		same(math_pow(-1, infinite), 1.0);
		same(math_pow(zero, 3), zero);
		same(math_pow(zero, -3), infinite);
		same(math_pow(zero, -2), INFINITY);
		same(math_pow(infinite, 3), infinite);
		same(math_pow(infinite, -3), zero);
	}
	same(math_asin(1.5), NAN);
	same(math_acos(-1.5), NAN);
	same(math_atan2(NAN, 1), NAN);
	same(math_hypot(NAN, 1), NAN);
	same(math_exp(-INFINITY), 0.0);
	same(math_exp(710), INFINITY);
	same(math_exp(-745.2), 0.0);
	same(math_exp(NAN), NAN);
	same(math_log(0), -INFINITY);
	same(math_log(-1), NAN);
	same(math_log(INFINITY), INFINITY);
	same(math_pow(1, NAN), 1.0);
	same(math_pow(NAN, 1), NAN);
	same(math_pow(-8, 1.0 / 3), NAN);
	same(math_pow(0.5, INFINITY), 0.0);
	same(math_pow(0.5, -INFINITY), INFINITY);
	same(math_pow(2, 1e300), INFINITY);
	same(math_pow(-1 - DBL_EPSILON, 0x1p600), INFINITY);
}
END_TEST

/* Arguments of all functions: small and large angles, points of all sizes. */
static double argument(struct random *random)
{
	return random_sign(random) * random_size(random, 1e-4, 1e6);
}

#define FUNCTIONS 13

static double result(int function, double x, double y)
{
	switch (function) {
	case 0:
		return math_sin(x);
	case 1:
		return math_cos(x);
	case 2:
		return math_tan(x);
	case 3:
		return math_atan2(y, x);
	case 4:
		return math_hypot(x, y);
	case 5:
		return math_asin(x / (fabs(x) + fabs(y)));
	case 6:
		return math_acos(x / (fabs(x) + fabs(y)));
	case 7:
		return math_exp(fmod(x, 700));
	case 8:
		return math_log(fabs(x));
	case 9:
		return math_log10(fabs(x));
	case 10:
		return math_sin_degrees(x);
	case 11:
		return math_pow(fabs(x), fmod(y, 40));
	default:
		return math_atan2_degrees(y, x);
	}
}

static long double truth(int function, double x, double y)
{
	const long double radian = 3.141592653589793238462643383279502884L / 180;

	switch (function) {
	case 0:
		return sinl(x);
	case 1:
		return cosl(x);
	case 2:
		return tanl(x);
	case 3:
		return atan2l(y, x);
	case 4:
		return hypotl(x, y);
	case 5:
		return asinl(x / (fabs(x) + fabs(y)));
	case 6:
		return acosl(x / (fabs(x) + fabs(y)));
	case 7:
		return expl(fmod(x, 700));
	case 8:
		return logl(fabs(x));
	case 9:
		return log10l(fabs(x));
	case 10:
		return sinl(fmod(x, 360) * radian);
	case 11:
		return powl(fabs(x), fmod(y, 40));
	default:
		return atan2l(y, x) / radian;
	}
}

START_TEST(agrees_with_long_doubles)
{
	/*
	 * The bound is larger where long doubles are not longer than doubles, and for the sine of degrees, which rounds
	 * the radians.
	 */
	const double most = LDBL_MANT_DIG >= 64 ? 0.505 : 1.5;
	struct random random = random_case(1, 0);

	for (long i = random_cases(200000); i > 0; i--) {
		const double x = argument(&random), y = argument(&random);
		const int function = random_below(&random, FUNCTIONS);
		const long double wanted = truth(function, x, y);
		const double got = result(function, x, y);
		const double place = ldexp(1, ilogb((double)wanted) - 52);
		const double off = (double)(fabsl(wanted - got) / place);

		require(off <= most + (function == 10 ? 0.01 / fabs(got) : 0),
			"function %d of %a, %a: %a, %.4f units off", function, x, y, got, off);
	}
}
END_TEST

/* The functions give the same bits on every computer and with every compiler; verdicts depend on this. */
START_TEST(bits_are_the_same_everywhere)
{
	uint64_t state = 1, hash = UINT64_C(0xcbf29ce484222325);

	for (int i = 0; i < 20000; i++) {
		double value[2];

		for (int k = 0; k < 2; k++) {
			/* Arguments as by splitmix64, because no function of the C library may make them. */
			uint64_t z = state += UINT64_C(0x9e3779b97f4a7c15);

			z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
			z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
			z ^= z >> 31;
			/* From 2^-20 to 2^44, with either sign. */
			z = (z & UINT64_C(0x800fffffffffffff)) | (1003 + (z >> 52 & 63)) << 52;
			memcpy(&value[k], &z, sizeof(z));
		}
		for (int function = 0; function < FUNCTIONS; function++) {
			const double got = result(function, value[0], value[1]);
			uint64_t bits;

			memcpy(&bits, &got, sizeof(bits));
			hash = (hash ^ bits) * UINT64_C(0x100000001b3);
			hash ^= hash >> 29;
		}
	}
	ck_assert_msg(hash == UINT64_C(0xf5c42ddd7f4b8539), "the bits have the sum 0x%llx", (unsigned long long)hash);
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {angles_in_degrees_are_exact, known_values, special_values,
				      agrees_with_long_doubles, bits_are_the_same_everywhere};

	return RUN_TESTS("math", tests);
}
