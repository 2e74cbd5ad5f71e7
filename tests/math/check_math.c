/*
 * check_math.c - the functions of base/math against MPFR.
 *
 * check_math COUNT [SEED]: COUNT arguments a function, of all sizes, and near the places that are hard: multiples of a
 * right angle, ends of the tables' steps, 1, the smallest and the largest numbers. Prints the largest error of each in
 * units in the last place and where it is, and exits with 1 where it is larger than 0.51.
 */
#include "base/math/math_functions.h"
#include "base/units.h"

#include <float.h>
#include <math.h>
#include <mpfr.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PRECISION 160
#define MOST_ULP 0.51

typedef double draw_fn(uint64_t *random);
typedef int true_fn(mpfr_t out, const mpfr_t x, mpfr_rnd_t rounding);

/* Steele, Lea and Flood, "Fast splittable pseudorandom number generators" (splitmix64). */
static uint64_t random_next(uint64_t *random)
{
	uint64_t z = *random += UINT64_C(0x9e3779b97f4a7c15);

	z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
	z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
	return z ^ z >> 31;
}

static double any_bits(uint64_t *random)
{
	const uint64_t bits = random_next(random);
	double x;

	memcpy(&x, &bits, sizeof(x));
	return isfinite(x) ? x : 1.5;
}

static double sign(uint64_t *random)
{
	return random_next(random) & 1 ? -1 : 1;
}

/* A number from 0 to 1, not 1 itself. */
static double fraction(uint64_t *random)
{
	return (double)(random_next(random) >> 11) * 0x1p-53;
}

/* A few units in the last place away, or none. */
static double nudged(uint64_t *random, double x)
{
	for (unsigned n = random_next(random) % 4; n > 0; n--)
		x = nextafter(x, random_next(random) & 1 ? INFINITY : -INFINITY);
	return x;
}

/* Between 2^low and 2^high, every size as often. */
static double of_size(uint64_t *random, int low, int high)
{
	const int exponent = low + (int)(random_next(random) % (unsigned)(high - low));

	return sign(random) * ldexp(1 + fraction(random), exponent);
}

static double draw_angle(uint64_t *random)
{
	switch (random_next(random) % 8) {
	case 0:
		return any_bits(random);
	case 1:
		return of_size(random, -40, 60);
	case 2: /* near a multiple of 1/128 of a turn, or between two */
		return nudged(random, 0.5 * PI / 64 * round(of_size(random, 0, 30)));
	case 3:
		return nudged(random, PI / 2 * round(of_size(random, 0, 52)));
	default:
		return sign(random) * 7 * fraction(random);
	}
}

static double draw_degrees(uint64_t *random)
{
	switch (random_next(random) % 8) {
	case 0:
		return any_bits(random);
	case 1:
		return of_size(random, -40, 60);
	case 2:
		return nudged(random, 1.40625 * round(of_size(random, 0, 30)));
	case 3:
		return nudged(random, 15 * round(of_size(random, 0, 20)));
	default:
		return sign(random) * 720 * fraction(random);
	}
}

static double draw_ratio(uint64_t *random)
{
	switch (random_next(random) % 4) {
	case 0:
		return of_size(random, -1074, 0);
	case 1:
		return sign(random) * (1 - ldexp(fraction(random), -(int)(random_next(random) % 54)));
	default:
		return sign(random) * fraction(random);
	}
}

static double draw_exponent(uint64_t *random)
{
	switch (random_next(random) % 4) {
	case 0:
		return of_size(random, -60, 10);
	case 1:
		return nudged(random, 0.693147180559945309 / 64 * round(of_size(random, 0, 16)));
	case 2: /* denormal and overflowing results */
		return random_next(random) & 1 ? -745.2 + 38 * fraction(random) : 709.8 - fraction(random);
	default:
		return 100 * (fraction(random) - 0.5);
	}
}

static double draw_positive(uint64_t *random)
{
	switch (random_next(random) % 4) {
	case 0:
		return fabs(any_bits(random));
	case 1:
		return 1 + ldexp(fraction(random) - 0.5, -(int)(random_next(random) % 54));
	case 2:
		return nudged(random, 1 + round(128 * fraction(random)) / 128);
	default:
		return 1000 * fraction(random);
	}
}

struct worst {
	double ulp, x, y, got;
};

/* What the error is in units of the last place of the true value. */
static void judge(struct worst *worst, const mpfr_t truth, double x, double y, double got)
{
	const double nearest = mpfr_get_d(truth, MPFR_RNDN);
	double ulp;
	mpfr_t off;

	if (isnan(nearest) && isnan(got))
		return;
	if (!isfinite(nearest) || !isfinite(got)) {
		/* The largest double and infinity are a unit apart. */
		const double bounded = fmin(fmax(nearest, -DBL_MAX), DBL_MAX), at = fmin(fmax(got, -DBL_MAX), DBL_MAX);

		ulp = isnan(got) || isnan(nearest) || bounded < at || bounded > at ? INFINITY : 0;
		if (isfinite(nearest) != isfinite(got) && ulp <= 0) {
			mpfr_t edge;

			mpfr_init2(edge, PRECISION);
			mpfr_set_d(edge, DBL_MAX, MPFR_RNDN);
			mpfr_sub(edge, truth, edge, MPFR_RNDN);
			mpfr_div_d(edge, edge, 0x1p971, MPFR_RNDN);
			ulp = fabs(mpfr_get_d(edge, MPFR_RNDN));
			ulp = isfinite(got) ? ulp : 1 - ulp;
			mpfr_clear(edge);
		}
	} else {
		int exponent = nearest < 0 || nearest > 0 ? (int)mpfr_get_exp(truth) - 53 : -1074;

		exponent = exponent < -1074 ? -1074 : exponent;
		mpfr_init2(off, PRECISION);
		mpfr_sub_d(off, truth, got, MPFR_RNDN);
		mpfr_mul_2si(off, off, -exponent, MPFR_RNDN);
		ulp = fabs(mpfr_get_d(off, MPFR_RNDN));
		mpfr_clear(off);
	}
	if (ulp > worst->ulp)
		*worst = (struct worst){ulp, x, y, got};
}

static bool told(const char *name, unsigned long count, const struct worst *worst)
{
	printf("%-14s %10lu arguments, largest error %.5f ulp, at %a %a: %a\n", name, count, worst->ulp, worst->x, worst->y,
	       worst->got);
	return worst->ulp <= MOST_ULP;
}

/* As MPFR 4.2 has them; sin, cos and tan of x 2 pi / 360. */
static int sin_degrees(mpfr_t out, const mpfr_t x, mpfr_rnd_t rounding)
{
	return mpfr_sinu(out, x, 360, rounding);
}

static int cos_degrees(mpfr_t out, const mpfr_t x, mpfr_rnd_t rounding)
{
	return mpfr_cosu(out, x, 360, rounding);
}

static int tan_degrees(mpfr_t out, const mpfr_t x, mpfr_rnd_t rounding)
{
	return mpfr_tanu(out, x, 360, rounding);
}

static int asin_degrees(mpfr_t out, const mpfr_t x, mpfr_rnd_t rounding)
{
	return mpfr_asinu(out, x, 360, rounding);
}

static int acos_degrees(mpfr_t out, const mpfr_t x, mpfr_rnd_t rounding)
{
	return mpfr_acosu(out, x, 360, rounding);
}

static const struct {
	const char *name;
	double (*ours)(double);
	true_fn *truth;
	draw_fn *draw;
} functions[] = {
	{"sin", math_sin, mpfr_sin, draw_angle},
	{"cos", math_cos, mpfr_cos, draw_angle},
	{"tan", math_tan, mpfr_tan, draw_angle},
	{"sin_degrees", math_sin_degrees, sin_degrees, draw_degrees},
	{"cos_degrees", math_cos_degrees, cos_degrees, draw_degrees},
	{"tan_degrees", math_tan_degrees, tan_degrees, draw_degrees},
	{"asin", math_asin, mpfr_asin, draw_ratio},
	{"acos", math_acos, mpfr_acos, draw_ratio},
	{"asin_degrees", math_asin_degrees, asin_degrees, draw_ratio},
	{"acos_degrees", math_acos_degrees, acos_degrees, draw_ratio},
	{"exp", math_exp, mpfr_exp, draw_exponent},
	{"log", math_log, mpfr_log, draw_positive},
	{"log10", math_log10, mpfr_log10, draw_positive},
};

static int atan2_degrees(mpfr_t out, const mpfr_t y, const mpfr_t x, mpfr_rnd_t rounding)
{
	return mpfr_atan2u(out, y, x, 360, rounding);
}

static void draw_point(uint64_t *random, double *y, double *x)
{
	switch (random_next(random) % 8) {
	case 0:
		*y = any_bits(random);
		*x = any_bits(random);
		return;
	case 1:
		*y = of_size(random, -80, 80);
		*x = of_size(random, -80, 80);
		return;
	case 2: /* near the ends of the tables' steps */
		*x = of_size(random, -10, 10);
		*y = nudged(random, *x * round(128 * fraction(random)) / 128);
		return;
	case 3: /* a quotient that is denormal, or nearly so */
		*x = of_size(random, 0, 1023);
		*y = of_size(random, -1074, 0);
		return;
	default:
		*y = sign(random) * 1000 * fraction(random);
		*x = sign(random) * 1000 * fraction(random);
	}
}

static void draw_power(uint64_t *random, double *x, double *y)
{
	switch (random_next(random) % 4) {
	case 0:
		*x = any_bits(random);
		*y = random_next(random) & 1 ? any_bits(random) : round(of_size(random, 0, 12));
		return;
	case 1: /* powers that are denormal or overflow */
		*x = fabs(of_size(random, -20, 20));
		*y = -(1015 + 60 * fraction(random)) / log2(*x);
		return;
	case 2:
		*x = 1 + ldexp(fraction(random) - 0.5, -(int)(random_next(random) % 50));
		*y = of_size(random, 0, 60);
		return;
	default:
		*x = 100 * fraction(random);
		*y = 20 * (fraction(random) - 0.5);
	}
}

static const struct {
	const char *name;
	double (*ours)(double, double);
	int (*truth)(mpfr_t, const mpfr_t, const mpfr_t, mpfr_rnd_t);
	void (*draw)(uint64_t *random, double *x, double *y);
} functions_of_two[] = {
	{"atan2", math_atan2, mpfr_atan2, draw_point},
	{"atan2_degrees", math_atan2_degrees, atan2_degrees, draw_point},
	{"hypot", math_hypot, mpfr_hypot, draw_point},
	{"pow", math_pow, mpfr_pow, draw_power},
};

int main(int argc, char **argv)
{
	const unsigned long count = argc > 1 ? strtoul(argv[1], NULL, 10) : 100000;
	uint64_t random = argc > 2 ? strtoull(argv[2], NULL, 10) : 1;
	bool good = true;
	mpfr_t out, x, y;

	mpfr_inits2(PRECISION, out, x, y, (mpfr_ptr)NULL);
	for (size_t f = 0; f < sizeof(functions) / sizeof(functions[0]); f++) {
		struct worst worst = {0};

		for (unsigned long i = 0; i < count; i++) {
			const double at = functions[f].draw(&random);

			mpfr_set_d(x, at, MPFR_RNDN);
			functions[f].truth(out, x, MPFR_RNDN);
			judge(&worst, out, at, 0, functions[f].ours(at));
		}
		good &= told(functions[f].name, count, &worst);
	}
	for (size_t f = 0; f < sizeof(functions_of_two) / sizeof(functions_of_two[0]); f++) {
		struct worst worst = {0};

		for (unsigned long i = 0; i < count; i++) {
			double a, b;

			functions_of_two[f].draw(&random, &a, &b);
			mpfr_set_d(x, a, MPFR_RNDN);
			mpfr_set_d(y, b, MPFR_RNDN);
			functions_of_two[f].truth(out, x, y, MPFR_RNDN);
			judge(&worst, out, a, b, functions_of_two[f].ours(a, b));
		}
		good &= told(functions_of_two[f].name, count, &worst);
	}
	mpfr_clears(out, x, y, (mpfr_ptr)NULL);
	mpfr_free_cache();
	return good ? 0 : 1;
}
