#include "base/math/double_double.h"
#include "base/math/math_functions.h"
#include "base/same_double.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

static const dd LOG_2 = {0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
static const dd LOG10_E = {0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};
static const dd THIRD = {0x1.5555555555555p-2, 0x1.5555555555555p-56};
static const dd SIXTH = {0x1.5555555555555p-3, 0x1.5555555555555p-57};

/* 2^(j/32) */
static const dd powers[32] = {
	{1, 0}, {0x1.059b0d3158574p0, 0x1.d73e2a475b465p-55}, {0x1.0b5586cf9890fp0, 0x1.8a62e4adc610bp-54},
	{0x1.11301d0125b51p0, -0x1.6c51039449b3ap-54}, {0x1.172b83c7d517bp0, -0x1.19041b9d78a76p-55},
	{0x1.1d4873168b9aap0, 0x1.e016e00a2643cp-54}, {0x1.2387a6e756238p0, 0x1.9b07eb6c70573p-54},
	{0x1.29e9df51fdee1p0, 0x1.612e8afad1255p-55}, {0x1.306fe0a31b715p0, 0x1.6f46ad23182e4p-55},
	{0x1.371a7373aa9cbp0, -0x1.63aeabf42eae2p-54}, {0x1.3dea64c123422p0, 0x1.ada0911f09ebcp-55},
	{0x1.44e086061892dp0, 0x1.89b7a04ef80dp-59}, {0x1.4bfdad5362a27p0, 0x1.d4397afec42e2p-56},
	{0x1.5342b569d4f82p0, -0x1.07abe1db13cadp-55}, {0x1.5ab07dd485429p0, 0x1.6324c054647adp-54},
	{0x1.6247eb03a5585p0, -0x1.383c17e40b497p-54}, {0x1.6a09e667f3bcdp0, -0x1.bdd3413b26456p-54},
	{0x1.71f75e8ec5f74p0, -0x1.16e4786887a99p-55}, {0x1.7a11473eb0187p0, -0x1.41577ee04992fp-55},
	{0x1.82589994cce13p0, -0x1.d4c1dd41532d8p-54}, {0x1.8ace5422aa0dbp0, 0x1.6e9f156864b27p-54},
	{0x1.93737b0cdc5e5p0, -0x1.75fc781b57ebcp-57}, {0x1.9c49182a3f09p0, 0x1.c7c46b071f2bep-56},
	{0x1.a5503b23e255dp0, -0x1.d2f6edb8d41e1p-54}, {0x1.ae89f995ad3adp0, 0x1.7a1cd345dcc81p-54},
	{0x1.b7f76f2fb5e47p0, -0x1.5584f7e54ac3bp-56}, {0x1.c199bdd85529cp0, 0x1.11065895048ddp-55},
	{0x1.cb720dcef9069p0, 0x1.503cbd1e949dbp-56}, {0x1.d5818dcfba487p0, 0x1.2ed02d75b3707p-55},
	{0x1.dfc97337b9b5fp0, -0x1.1a5cd4f184b5cp-54}, {0x1.ea4afa2a490dap0, -0x1.e9c23179c2893p-54},
	{0x1.f50765b6e454p0, 0x1.9d3e12dd8a18bp-54},};

/* log(2)/32 is the sum of the first, with 36 bits, whose product with a number of 17 bits is exact, and the second. */
#define STEP_UPPER 0x1.62e42fefap-6
static const dd STEP_LOWER = {0x1.cf79abc9e3b3ap-45, -0x1.ff0342542fc33p-99};
#define STEPS_PER_UNIT 0x1.71547652b82fep+5
/* e to a power beyond these is infinite, or 0, rounded to a double. */
#define OVERFLOWS 710
#define VANISHES -746
/* Adding and subtracting this rounds to a whole number, half to even. */
#define ROUNDING 0x1.8p52

/*
 * A number of nine bits near the reciprocals of 1 + i/64 to 1 + (i + 1)/64, and its logarithm with the opposite sign.
 * From i = 27 on the mantissa is treated as twice a number below 1, so that the logarithms near 1 are small on both
 * sides.
 */
struct reciprocal {
	double value;
	dd minus_log;
};
#define HALVED_FROM 27

static const struct reciprocal reciprocals[64] = {
	{0x1p0, {0, 0}}, {0x1.f4p-1, {0x1.8492528c8cabfp-6, -0x1.d192d0619fa67p-60}},
	{0x1.edp-1, {0x1.35c8bfaa1306bp-5, -0x1.50830a65543a4p-63}},
	{0x1.e5p-1, {0x1.bbcebfc68f42p-5, 0x1.e5cf3a0f56f72p-60}},
	{0x1.dep-1, {0x1.1973bd1465567p-4, -0x1.7558367a6acf6p-59}},
	{0x1.d7p-1, {0x1.55e10050e0384p-4, -0x1.45f9d61c68c1bp-58}},
	{0x1.d1p-1, {0x1.8a6477a91dc29p-4, -0x1.fa83214904842p-59}},
	{0x1.cap-1, {0x1.c885801bc4b23p-4, 0x1.a38cb559a6706p-58}},
	{0x1.c4p-1, {0x1.fe89139dbd566p-4, -0x1.ac9f4215f9393p-58}},
	{0x1.bep-1, {0x1.1aa2b7e23f72ap-3, -0x1.c6ef1d9b2ef7ep-59}},
	{0x1.b8p-1, {0x1.365fcb0159016p-3, 0x1.7d411a5b944adp-58}},
	{0x1.b2p-1, {0x1.527e5e4a1b58dp-3, -0x1.71a9682395bfdp-61}},
	{0x1.acp-1, {0x1.6f0128b756abcp-3, -0x1.8de59c21e166cp-57}},
	{0x1.a7p-1, {0x1.871213750e994p-3, 0x1.d685f35eea2ap-57}},
	{0x1.a1p-1, {0x1.a454082e6ab05p-3, 0x1.df207dc5c34c6p-58}},
	{0x1.9cp-1, {0x1.bd087383bd8adp-3, 0x1.dd355f6a516d7p-60}},
	{0x1.97p-1, {0x1.d60a17f903515p-3, -0x1.c0df841a71b7ap-57}},
	{0x1.92p-1, {0x1.ef5ade4dcffe6p-3, -0x1.08ab2ddc708ap-58}},
	{0x1.8dp-1, {0x1.047e60cde83b8p-2, -0x1.0779634061cbcp-56}},
	{0x1.88p-1, {0x1.1178e8227e47cp-2, -0x1.0e63a5f01c691p-57}},
	{0x1.84p-1, {0x1.1bf99635a6b95p-2, -0x1.12aeb84249223p-57}},
	{0x1.7fp-1, {0x1.2941afb186b7cp-2, -0x1.856e61c51574p-57}},
	{0x1.7bp-1, {0x1.3401e12aecba1p-2, -0x1.cd55b8a4746cp-58}},
	{0x1.76p-1, {0x1.419b423d5e8c7p-2, 0x1.0dbb243827392p-57}},
	{0x1.72p-1, {0x1.4c9e09e172c3cp-2, -0x1.123615b147a5dp-58}},
	{0x1.6ep-1, {0x1.57bf753c8d1fbp-2, -0x1.0908d15f88b63p-57}},
	{0x1.6ap-1, {0x1.630030b3aac49p-2, 0x1.dc18ce51fff99p-57}},
	{0x1.66p-1, {-0x1.5767717455a6cp-2, -0x1.526adb283660cp-56}},
	{0x1.62p-1, {-0x1.4be5f957778a1p-2, 0x1.259b35b04813dp-57}},
	{0x1.5ep-1, {-0x1.404308686a7e4p-2, 0x1.0bcfb6082ce6dp-56}},
	{0x1.5bp-1, {-0x1.3772662bfd85bp-2, 0x1.b5629d8117de7p-59}},
	{0x1.57p-1, {-0x1.2b9303ab89d25p-2, 0x1.896b5fd852ad4p-56}},
	{0x1.54p-1, {-0x1.22941fbcf7966p-2, 0x1.76f5eb09628afp-56}},
	{0x1.5p-1, {-0x1.1675cababa60ep-2, -0x1.ce63eab883717p-61}},
	{0x1.4dp-1, {-0x1.0d46b579ab74bp-2, -0x1.03ec81c3cbd92p-57}},
	{0x1.49p-1, {-0x1.00e6c45ad501dp-2, 0x1.cb9568ff6feadp-57}},
	{0x1.46p-1, {-0x1.ef0adcbdc5936p-3, -0x1.48637950dc20dp-57}},
	{0x1.43p-1, {-0x1.dc1bca0abec7dp-3, -0x1.834c51998b6fcp-57}},
	{0x1.4p-1, {-0x1.c8ff7c79a9a22p-3, 0x1.4f689f8434012p-57}},
	{0x1.3dp-1, {-0x1.b5b519e8fb5a4p-3, -0x1.ba27fdc19e1ap-57}},
	{0x1.3ap-1, {-0x1.a23bc1fe2b563p-3, -0x1.93711b07a998cp-59}},
	{0x1.37p-1, {-0x1.8e928de886d41p-3, 0x1.569d851a5677p-57}},
	{0x1.34p-1, {-0x1.7ab890210d909p-3, -0x1.be36b2d6a0608p-59}},
	{0x1.31p-1, {-0x1.66acd4272ad51p-3, 0x1.0900e4e1ea8b2p-58}},
	{0x1.2ep-1, {-0x1.526e5e3a1b438p-3, 0x1.746ff8a470d3ap-57}},
	{0x1.2bp-1, {-0x1.3dfc2b0ecc62ap-3, 0x1.ab3a8e7d81017p-58}},
	{0x1.29p-1, {-0x1.303d718e47fd3p-3, 0x1.6b9c7d96091fap-63}},
	{0x1.26p-1, {-0x1.1b72ad52f67ap-3, -0x1.483023472cd74p-58}},
	{0x1.23p-1, {-0x1.0671512ca596ep-3, -0x1.50c647eb86499p-58}},
	{0x1.21p-1, {-0x1.f0a30c01162a6p-4, -0x1.85f325c5bbacdp-58}},
	{0x1.1ep-1, {-0x1.c5e548f5bc743p-4, -0x1.5d617ef8161b1p-60}},
	{0x1.1cp-1, {-0x1.a926d3a4ad563p-4, -0x1.942f48aa70ea9p-58}},
	{0x1.19p-1, {-0x1.7da766d7b12cdp-4, 0x1.eeedfcdd94131p-58}},
	{0x1.17p-1, {-0x1.60658a93750c4p-4, 0x1.388458ec21b6ap-58}},
	{0x1.15p-1, {-0x1.42edcbea646fp-4, -0x1.ddd4f935996c9p-59}},
	{0x1.12p-1, {-0x1.16536eea37ae1p-4, 0x1.79da3e8c22cdap-60}},
	{0x1.1p-1, {-0x1.f0a30c01162a6p-5, -0x1.85f325c5bbacdp-59}},
	{0x1.0ep-1, {-0x1.b42dd711971bfp-5, 0x1.eb9759c130499p-60}},
	{0x1.0bp-1, {-0x1.58a5bafc8e4d5p-5, 0x1.ce55c2b4e2b72p-59}},
	{0x1.09p-1, {-0x1.1b0d98923d98p-5, 0x1.e9ae889bac481p-60}},
	{0x1.07p-1, {-0x1.b9fc027af9198p-6, 0x1.0ae69229dc868p-64}},
	{0x1.05p-1, {-0x1.3cea44346a575p-6, 0x1.0cb5a902b3a1cp-62}},
	{0x1.03p-1, {-0x1.7dc475f810a77p-7, 0x1.16d7687d3df21p-62}}, {0x1p-1, {0, 0}},};

double dd_scaled(dd a, int exponent)
{
	const int size = (int)(bits_of(a.hi) >> 52 & 0x7ff) - 1023 + exponent, half = exponent / 2;

	/* Less than half of the smallest number. */
	if (size < -1076)
		return copysign(0, a.hi);
	if (size < -1022) {
		/* Beside this number, the last place is that of the denormal numbers. */
		const double large = copysign(power_of_two(-1022 - exponent), a.hi);
		const dd sum = two_sum(large, a.hi);

		a.hi = copysign((sum.hi + (sum.lo + a.lo)) - large, a.hi);
		a.lo = -0.0;	/* which leaves -0 as it is */
	}
	return (a.hi + a.lo) * power_of_two(half) * power_of_two(exponent - half);
}

/* e^x, with a relative error of 2^-80. */
static double exponential(dd x)
{
	const double k = (x.hi * STEPS_PER_UNIT + ROUNDING) - ROUNDING;
	const int whole = (int)k, j = whole & 31;
	const dd near = two_sum(x.hi - k * STEP_UPPER, x.lo);
	const dd lower = dd_multiply((dd){-k, 0}, STEP_LOWER);
	const dd r = dd_add(near, lower), square = dd_multiply(r, r);
	const double fourth = 0x1.5555555555555p-5 +
			      r.hi * (0x1.1111111111111p-7 +
				      r.hi * (0x1.6c16c16c16c17p-10 +
					      r.hi * (0x1.a01a01a01a01ap-13 + r.hi * 0x1.a01a01a01a01ap-16)));
	/* r^2 (1/2 + r/6 + r^2/24 + ...) */
	const dd inner = dd_add(dd_multiply(r, SIXTH), (dd){square.hi * fourth, 0});
	const dd less_one = dd_add(r, dd_multiply(square, dd_add((dd){0.5, 0}, inner)));

	return dd_scaled(dd_add(powers[j], dd_multiply(powers[j], less_one)), (whole - j) / 32);
}

/* log(1 + r), |r| <= 1/64, with a relative error of 2^-75. */
static dd logarithm_near_one(dd r)
{
	/* 1/5 - r/6 + ... + r^10/15 */
	double fifth = 0;
	dd sum;

	for (int n = 15; n >= 5; n--)
		fifth = (n % 2 ? 1.0 : -1.0) / n + fifth * r.hi;
	/* r - r^2/2 + r^3/3 - r^4/4 + r^5 (...) */
	sum = dd_add((dd){-0.25, 0}, (dd){r.hi * fifth, 0});
	sum = dd_add(THIRD, dd_multiply(r, sum));
	sum = dd_add((dd){-0.5, 0}, dd_multiply(r, sum));
	return dd_add(r, dd_multiply(dd_multiply(r, r), sum));
}

/* For a finite number > 0, with a relative error of 2^-72. */
static dd logarithm(double x)
{
	int exponent;
	const double mantissa = 2 * frexp(x, &exponent);
	const int i = (int)((mantissa - 1) * 64);
	const struct reciprocal *reciprocal = &reciprocals[i];
	/* In 53 + 9 bits, exactly. */
	const dd product = two_product(mantissa, reciprocal->value);
	const dd r = two_sum(product.hi - 1, product.lo);
	const double doublings = exponent - (i < HALVED_FROM);

	return dd_add(dd_multiply((dd){doublings, 0}, LOG_2), dd_add(reciprocal->minus_log, logarithm_near_one(r)));
}

double math_exp(double x)
{
	if (isnan(x))
		return x;
	if (x > OVERFLOWS)
		return INFINITY;
	return x < VANISHES ? 0 : exponential((dd){x, 0});
}

/* The logarithm of a number that has no finite one. */
static double special_logarithm(double x)
{
	if (isnan(x) || x > 0)
		return x;
	return x < 0 ? NAN : -INFINITY;
}

double math_log(double x)
{
	dd log;

	if (!(x > 0 && x <= DBL_MAX))
		return special_logarithm(x);
	log = logarithm(x);
	return log.hi + log.lo;
}

double math_log10(double x)
{
	dd log;

	if (!(x > 0 && x <= DBL_MAX))
		return special_logarithm(x);
	log = dd_multiply(logarithm(x), LOG10_E);
	return log.hi + log.lo;
}

/* x^y if one of them is 0 or infinite, the other is a number, and y is not 0. */
static double special_power(double x, double y, bool odd)
{
	const double size = fabs(x);
	double power;

	if (isinf(y) && !(size < 1) && !(size > 1))
		return 1;
	if (isinf(y))
		return (size > 1) == (y > 0) ? INFINITY : 0;
	power = (isinf(x) != 0) == (y > 0) ? INFINITY : 0;
	return odd ? copysign(power, x) : power;
}

double math_pow(double x, double y)
{
	const bool whole = same_double(floor(y), y), odd = whole && fabs(fmod(y, 2)) > 0;
	dd log;
	double power;

	if (fabs(y) <= 0 || (!isnan(x) && same_double(x, 1)))
		return 1;
	if (isnan(x) || isnan(y))
		return x + y;
	if (fabs(x) <= 0 || isinf(x) || isinf(y))
		return special_power(x, y, odd && isfinite(y));
	if (x < 0 && !whole)
		return NAN;
	/* Powers beyond those of 2^65 are 0, 1 or infinite as well. */
	log = dd_multiply(logarithm(fabs(x)), (dd){fmin(fmax(y, -0x1p65), 0x1p65), 0});
	if (log.hi > OVERFLOWS)
		power = INFINITY;
	else
		power = log.hi < VANISHES ? 0 : exponential(log);
	return x < 0 && odd ? -power : power;
}
