#include "base/math/double_double.h"
#include "base/math/math_functions.h"

#include <math.h>
#include <stddef.h>

/*
 * An angle is k pi/64 + r with |r| <= pi/128. The table has the sine of k pi/64, and so its cosine; two short
 * polynomials give those of r, and the addition theorems those of the sum.
 */

/* The remaining part of an angle, and its properties. */
struct turn {
	unsigned steps;	/* k, modulo a full turn of 128 */
	dd rest;		/* r, in radians */
};

/* The sines of k pi/64, each in 26 bits and the rest. */
static const dd sines[33] = {
	{0, 0}, {0x1.91f65fp-5, 0x1.0dd813e6ed42fp-33}, {0x1.917a6cp-4, -0x1.eb25ea0f138c7p-31},
	{0x1.2c8107p-3, -0x1.719ec5dd9ffebp-31}, {0x1.8f8b84p-3, -0x1.cb2cfaa4da337p-30},
	{0x1.f19f978p-3, 0x1.90af8d57a4222p-30}, {0x1.294063p-2, -0x1.2a60fa574a369p-30},
	{0x1.58f9a78p-2, -0x1.2a701180f7eep-29}, {0x1.87de2a8p-2, -0x1.51569d2e59dbap-30},
	{0x1.b5d1008p-2, 0x1.e15cc02b66c59p-30}, {0x1.e2b5d38p-2, 0x1.bd8ec78362475p-36},
	{0x1.0738798p-1, 0x1.22ffed9697fafp-29}, {0x1.1c73b38p-1, 0x1.ae68c86c9774ap-29},
	{0x1.30ff8p-1, -0x1.8f47e58f7e631p-28}, {0x1.44cf328p-1, -0x1.7b7114f3fc4afp-28},
	{0x1.57d6938p-1, -0x1.b989b02eae413p-28}, {0x1.6a09e68p-1, -0x1.80c4336f74d05p-29},
	{0x1.7b5df2p-1, 0x1.3557d76f0ac85p-28}, {0x1.8bc8068p-1, 0x1.8a8ba05a743dap-28},
	{0x1.9b3e048p-1, -0x1.8f17e98771434p-34}, {0x1.a9b6628p-1, 0x1.0ea1a3033ec62p-29},
	{0x1.b728348p-1, -0x1.7348e1378d3e6p-28}, {0x1.c38b2fp-1, 0x1.80bdb0d23e9d1p-29},
	{0x1.ced7af8p-1, -0x1.e19c46879edafp-28}, {0x1.d906bdp-1, -0x1.9ae573aea067cp-30},
	{0x1.e212108p-1, -0x1.84bc8da0298eep-28}, {0x1.e9f4158p-1, -0x1.39d225a27d387p-29},
	{0x1.f0a7ef8p-1, 0x1.c9186b952c7aep-28}, {0x1.f6297dp-1, -0x1.1469faa77a357p-34},
	{0x1.fa7558p-1, -0x1.eeb5d2bd05465p-30}, {0x1.fd88dap-1, 0x1.e89292cf04139p-28},
	{0x1.ff621ep-1, 0x1.bcb6bef1d421fp-28}, {1, 0},};

/* pi/64 = the sum of these: three of 31 bits, whose products with a number of 22 bits are exact, and a rest. */
static const double step[4] = {0x1.921fb544p-5, 0x1.0b4611a8p-39, -0x1.d9cceba4p-71, 0x1.b839a252049c1p-109};
static const dd STEP = {0x1.921fb54442d18p-5, 0x1.1a62633145c07p-59};
static const dd DEGREE = {0x1.1df46a2529d39p-6, 0x1.5c1d8becdd291p-62};
#define STEPS_PER_RADIAN 0x1.45f306dc9c883p+4
/* Exactly pi/64. */
#define STEP_DEGREES 2.8125
/* Up to this angle, k has 22 bits. */
#define LARGE_ANGLE 0x1p17
/* Up to this angle, the quotient of degrees by a step is a whole number that a double holds with its fraction. */
#define LARGE_DEGREES 0x1p30
/* Below this, x - x^3/6 rounds to x and 1 - x^2/2 to 1. */
#define SMALL_ANGLE 0x1p-30
/* Adding and subtracting this rounds to a whole number, half to even. */
#define ROUNDING 0x1.8p52

/* 2/pi = 0.w0 w1 w2 ... in digits of 32 bits. */
static const uint32_t two_over_pi[] = {
	0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab, 0xdebbc561,
	0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484,
	0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff, 0xde05980f,
	0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7, 0xebe5f17b,
	0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab,
};
#define WORDS 7		/* of them that matter to one angle */

static double nearest_integer(double x)
{
	return (x + ROUNDING) - ROUNDING;
}

static unsigned modulo_turn(double k)
{
	return (unsigned)(int64_t)k & 127;
}

/* 32 bits of the number whose 32-bit digits, the lowest first, are `digits`, from bit `at` up. */
static uint32_t bits_from(const uint32_t *digits, unsigned at)
{
	const uint64_t pair = digits[at / 32] | (uint64_t)digits[at / 32 + 1] << 32;

	return (uint32_t)(pair >> at % 32);
}

/* The fraction with these first 128 bits, minus 1 if it is more than a half, in radians. */
static dd fraction_of_step(const uint32_t fraction[4])
{
	const uint32_t flip = fraction[0] >> 31 ? UINT32_MAX : 0;
	const double sign = flip ? -1 : 1;
	dd sum = {0, 0};

	for (int i = 0; i < 4; i++) {
		const double digit = sign * (double)(fraction[i] ^ flip) * power_of_two(-32 * (i + 1));
		const dd upper = two_sum(sum.hi, digit);

		sum = quick_two_sum(upper.hi, upper.lo + sum.lo);
	}
	return dd_multiply(sum, STEP);
}

/*
 * Payne and Hanek: only the digits of 2/pi that matter for the size of the angle are multiplied by its mantissa. The
 * digits before them add whole turns. 224 bits leave an error of 2^-133 of a step, and no double is nearer to a step
 * than 2^-62.
 */
static struct turn turn_of_large(double angle)
{
	const uint64_t bits = bits_of(fabs(angle)), mantissa = (bits & 0xfffffffffffffU) | (uint64_t)1 << 52;
	const int exponent = (int)(bits >> 52) - 1075, first = exponent < 2 ? 0 : (exponent - 2) / 32;
	const unsigned point = (unsigned)(32 * (first + WORDS) - exponent - 5);
	const uint32_t halves[2] = {(uint32_t)mantissa, (uint32_t)(mantissa >> 32)};
	uint32_t product[WORDS + 4] = {0}, fraction[4];
	struct turn turn;

	for (size_t i = 0; i < WORDS; i++) {
		uint64_t carry = 0;

		for (size_t j = 0; j < 2; j++) {
			carry += (uint64_t)two_over_pi[(size_t)first + WORDS - 1 - i] * halves[j] + product[i + j];
			product[i + j] = (uint32_t)carry;
			carry >>= 32;
		}
		product[i + 2] = (uint32_t)carry;
	}
	for (unsigned i = 0; i < 4; i++)
		fraction[i] = bits_from(product, point - 32 * (i + 1));
	turn.steps = bits_from(product, point) + (fraction[0] >> 31);
	turn.rest = fraction_of_step(fraction);
	if (angle < 0) {
		turn.steps = -turn.steps;
		turn.rest = dd_negative(turn.rest);
	}
	turn.steps &= 127;
	return turn;
}

static struct turn turn_of(double angle)
{
	double k, near;
	dd rest;

	if (!(fabs(angle) < LARGE_ANGLE))
		return turn_of_large(angle);
	k = nearest_integer(angle * STEPS_PER_RADIAN);
	near = angle - k * step[0];
	rest = two_sum(near, -k * step[1]);
	if (fabs(rest.hi) < SMALL_ANGLE) {
		/* Near a multiple of the step, the parts of the step that did not matter before are needed. */
		rest = dd_add(rest, (dd){-k * step[2], 0});
		rest = dd_add(rest, (dd){-k * step[3], 0});
	} else {
		rest = quick_two_sum(rest.hi, rest.lo - k * (step[2] + step[3]));
	}
	return (struct turn){modulo_turn(k), rest};
}

static struct turn turn_of_degrees(double angle)
{
	double k, rest;
	dd radians;

	if (fabs(angle) > LARGE_DEGREES)
		angle = fmod(angle, 360);
	k = nearest_integer(angle / STEP_DEGREES);
	rest = angle - k * STEP_DEGREES;
	radians = two_product(rest, DEGREE.hi);
	radians.lo += rest * DEGREE.lo;
	return (struct turn){modulo_turn(k), radians};
}

/* The values of the polynomials for the rest r = hi + lo. */
struct small_angle {
	double upper, lower;	/* hi in 26 bits, and what remains of r */
	double hi;
	double sine_tail;	/* sin r - r */
	double cosine_tail;	/* cos r - 1 */
};

static struct small_angle small_angle_of(dd r)
{
	const double square = r.hi * r.hi, upper = upper_half(r.hi);
	/* -1/6 + r^2/120 - r^4/5040 + r^6/362880 and -1/2 + r^2/24 - r^4/720 + r^6/40320 */
	const double sine_end = -0x1.a01a01a01a01ap-13 + square * 0x1.71de3a556c734p-19;
	const double sine = -0x1.5555555555555p-3 + square * (0x1.1111111111111p-7 + square * sine_end);
	const double cosine_end = -0x1.6c16c16c16c17p-10 + square * 0x1.a01a01a01a01ap-16;
	const double cosine = -0.5 + square * (0x1.5555555555555p-5 + square * cosine_end);

	return (struct small_angle){upper, (r.hi - upper) + r.lo, r.hi, r.hi * square * sine,
				    square * cosine - r.hi * r.lo};
}

/* a cos r + b sin r, with a and b from the table. */
static dd added(dd a, dd b, const struct small_angle *r)
{
	const dd sum = two_sum(a.hi, b.hi * r->upper);
	const double low = b.hi * r->lower + b.lo * r->hi;
	const double tails = (b.hi + b.lo) * r->sine_tail + (a.hi + a.lo) * r->cosine_tail;

	return (dd){sum.hi, sum.lo + (a.lo + (low + tails))};
}

static dd signed_as(dd value, unsigned negative)
{
	const double sign = negative ? -1 : 1;

	return (dd){sign * value.hi, sign * value.lo};
}

/* The table's values for the steps of the turn: the sine and the cosine of the part before the rest. */
static void look_up(struct turn turn, dd *sine, dd *cosine)
{
	const unsigned quadrant = turn.steps / 32, k = turn.steps % 32, odd = quadrant & 1;

	*sine = signed_as(sines[odd ? 32 - k : k], quadrant & 2);
	*cosine = signed_as(sines[odd ? k : 32 - k], (quadrant + 1) & 2);
}

static dd sine_of(struct turn turn)
{
	const struct small_angle small = small_angle_of(turn.rest);
	dd s, c;

	look_up(turn, &s, &c);
	return added(s, c, &small);
}

/* The sine of the turn plus a quarter. */
static dd cosine_of(struct turn turn)
{
	turn.steps = (turn.steps + 32) & 127;
	return sine_of(turn);
}

static void sine_and_cosine(struct turn turn, dd *sine, dd *cosine)
{
	const struct small_angle small = small_angle_of(turn.rest);
	dd s, c;

	look_up(turn, &s, &c);
	*sine = added(s, c, &small);
	*cosine = added(c, dd_negative(s), &small);
}

void math_sin_cos(double angle, double *sine, double *cosine)
{
	dd s, c;

	if (fabs(angle) < SMALL_ANGLE) {
		*sine = angle;
		*cosine = 1;
		return;
	}
	if (!isfinite(angle)) {
		*sine = *cosine = angle - angle;
		return;
	}
	sine_and_cosine(turn_of(angle), &s, &c);
	*sine = s.hi + s.lo;
	*cosine = c.hi + c.lo;
}

double math_sin(double angle)
{
	dd sine;

	if (fabs(angle) < SMALL_ANGLE || !isfinite(angle))
		return isfinite(angle) ? angle : angle - angle;
	sine = sine_of(turn_of(angle));
	return sine.hi + sine.lo;
}

double math_cos(double angle)
{
	dd cosine;

	if (fabs(angle) < SMALL_ANGLE || !isfinite(angle))
		return isfinite(angle) ? 1 : angle - angle;
	cosine = cosine_of(turn_of(angle));
	return cosine.hi + cosine.lo;
}

static double tangent(struct turn turn)
{
	dd sine, cosine, quotient;

	sine_and_cosine(turn, &sine, &cosine);
	quotient = dd_divide(quick_two_sum(sine.hi, sine.lo), quick_two_sum(cosine.hi, cosine.lo));
	return quotient.hi + quotient.lo;
}

double math_tan(double angle)
{
	if (fabs(angle) < SMALL_ANGLE || !isfinite(angle))
		return isfinite(angle) ? angle : angle - angle;
	return tangent(turn_of(angle));
}

/* So small that sine and tangent are the angle in radians, which may be denormal. */
static double tiny_radians(double angle)
{
	const dd product = dd_multiply((dd){angle * 0x1p600, 0}, DEGREE);

	return fabs(angle) > 0 ? dd_scaled(product, -600) : angle;
}

double math_sin_degrees(double angle)
{
	dd sine;

	if (fabs(angle) < SMALL_ANGLE || !isfinite(angle))
		return isfinite(angle) ? tiny_radians(angle) : angle - angle;
	sine = sine_of(turn_of_degrees(angle));
	return sine.hi + sine.lo + 0;	/* no -0 */
}

double math_cos_degrees(double angle)
{
	dd cosine;

	if (!isfinite(angle))
		return angle - angle;
	cosine = cosine_of(turn_of_degrees(angle));
	return cosine.hi + cosine.lo + 0;
}

double math_tan_degrees(double angle)
{
	dd sine, cosine, quotient;

	if (fabs(angle) < SMALL_ANGLE || !isfinite(angle))
		return isfinite(angle) ? tiny_radians(angle) : angle - angle;
	sine_and_cosine(turn_of_degrees(angle), &sine, &cosine);
	if (fabs(cosine.hi) <= 0)
		return copysign(INFINITY, sine.hi);
	quotient = dd_divide(quick_two_sum(sine.hi, sine.lo), quick_two_sum(cosine.hi, cosine.lo));
	return quotient.hi + quotient.lo + 0;
}
