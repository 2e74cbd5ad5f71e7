/*
 * double_double.h - unevaluated sums of two doubles, about 105 bits. For the functions of this folder alone.
 *
 * Source: Dekker, "A floating-point technique for extending the available precision", 1971. Exact means: as long as
 * nothing overflows or becomes denormal.
 */
#ifndef FIVECHECK_BASE_MATH_DOUBLE_DOUBLE_H
#define FIVECHECK_BASE_MATH_DOUBLE_DOUBLE_H

#include <stdint.h>
#include <string.h>

/* Worth hi + lo. lo is small beside hi, but may be more than half a unit in its last place. */
typedef struct dd {
	double hi, lo;
} dd;

static inline uint64_t bits_of(double x)
{
	uint64_t bits;

	memcpy(&bits, &x, sizeof(bits));
	return bits;
}

static inline double double_of(uint64_t bits)
{
	double x;

	memcpy(&x, &bits, sizeof(x));
	return x;
}

/* 2^exponent, for a normal result. */
static inline double power_of_two(int exponent)
{
	return double_of((uint64_t)(exponent + 1023) << 52);
}

/* x without the last 27 bits of its mantissa: the product of two such numbers is exact. */
static inline double upper_half(double x)
{
	return double_of(bits_of(x) & ~(uint64_t)0x7ffffff);
}

/* a + b, exactly, where |a| >= |b| or a is 0. */
static inline dd quick_two_sum(double a, double b)
{
	const double sum = a + b;

	return (dd){sum, b - (sum - a)};
}

/* a + b, exactly. */
static inline dd two_sum(double a, double b)
{
	const double sum = a + b, from_b = sum - a;

	return (dd){sum, (a - (sum - from_b)) + (b - from_b)};
}

/* a b, to 2^-105 of it. */
static inline dd two_product(double a, double b)
{
	const double product = a * b, ah = upper_half(a), al = a - ah, bh = upper_half(b), bl = b - bh;

	return (dd){product, ((ah * bh - product) + ah * bl + al * bh) + al * bl};
}

static inline dd dd_negative(dd a)
{
	return (dd){-a.hi, -a.lo};
}

static inline dd dd_add(dd a, dd b)
{
	const dd sum = two_sum(a.hi, b.hi), low = two_sum(a.lo, b.lo), first = quick_two_sum(sum.hi, sum.lo + low.hi);

	return quick_two_sum(first.hi, first.lo + low.lo);
}

static inline dd dd_multiply(dd a, dd b)
{
	const dd product = two_product(a.hi, b.hi);

	return quick_two_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

static inline dd dd_divide(dd a, dd b)
{
	const double quotient = a.hi / b.hi;
	const dd product = two_product(quotient, b.hi);
	const double rest = ((a.hi - product.hi) - product.lo) + (a.lo - quotient * b.lo);

	return (dd){quotient, rest / b.hi};
}

/*
 * (hi + lo) 2^exponent, rounded once also where the result is denormal. 2^-60 <= |hi| <= 2^60; the exponent is 1500
 * at most. In math_exponential.c.
 */
double dd_scaled(dd a, int exponent);

#endif
