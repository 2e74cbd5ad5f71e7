#include "base/decimal.h"

#include <locale.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"

/* As an integer and a power of ten. */
struct decimal {
	bool negative;
	bool exact;	/* the integer holds all digits */
	uint64_t digits;
	int exponent;
};

static const char *scan_digits(struct decimal *d, const char *at, int shift)
{
	for (; ascii_is_digit(*at); at++) {
		if (d->digits > (UINT64_MAX - 9) / 10) {
			d->exact = false;
			continue;
		}
		d->digits = 10 * d->digits + (uint64_t)(*at - '0');
		d->exponent -= shift;
	}
	return at;
}

/* False unless the word is [+-]digits[.digits][e[+-]digits] with a digit before the exponent. */
static bool scan_decimal(struct decimal *d, const char *word, size_t length)
{
	const char *at = word, *whole, *point;
	int exponent = 0;

	*d = (struct decimal){.exact = true, .negative = *at == '-'};
	whole = at += *at == '-' || *at == '+';
	at = point = scan_digits(d, at, 0);
	if (*at == '.')
		at = scan_digits(d, at + 1, 1);
	if (at == whole || (at == point + 1 && point == whole))
		return false;
	if (*at == 'e' || *at == 'E') {
		bool negative = at[1] == '-';
		const char *first = at + 1 + (at[1] == '-' || at[1] == '+');

		for (at = first; ascii_is_digit(*at); at++)
			exponent = exponent < 10000 ? 10 * exponent + (*at - '0') : exponent;
		if (at == first)
			return false;
		d->exponent += negative ? -exponent : exponent;
	}
	return at == word + length;
}

/* The nearest double, if it can be computed cheaply: both factors are exact, so there is only one rounding. */
static bool quick_value(const struct decimal *d, double *value)
{
	static const double tens[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
				      1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
	double v = (double)d->digits;

	if (!d->exact || d->digits > (uint64_t)1 << 53 || abs(d->exponent) > 22)
		return false;
	v = d->exponent < 0 ? v / tens[-d->exponent] : v * tens[d->exponent];
	*value = d->negative ? -v : v;
	return true;
}

/* Does rounding this double again give the float nearest to the decimal? Not if it is half-way between two. */
static bool rounds_once(double value)
{
	const uint64_t below_float = ((uint64_t)1 << 29) - 1, half_way = (uint64_t)1 << 28;
	uint64_t bits;

	/* Between 1e-22 and 1e38 floats are neither subnormal nor infinite. */
	memcpy(&bits, &value, sizeof(bits));
	return (bits & below_float) != half_way;
}

/* The C library's conversions depend on the thread's locale: they are called in the C locale. */
static void read_slowly(const char *word, float *nearest, double *value)
{
	locale_t c = newlocale(LC_ALL_MASK, "C", (locale_t)0), previous = uselocale(c);

	*nearest = strtof(word, NULL);
	*value = strtod(word, NULL);
	uselocale(previous);
	if (c)
		freelocale(c);
}

bool decimal_read(const char *word, size_t length, double *value)
{
	struct decimal d;
	float unused;

	if (!scan_decimal(&d, word, length))
		return false;
	if (!quick_value(&d, value))
		read_slowly(word, &unused, value);
	return true;
}

bool decimal_read_float(const char *word, size_t length, float *nearest, double *value)
{
	struct decimal d;

	if (!scan_decimal(&d, word, length))
		return false;
	if (quick_value(&d, value) && rounds_once(*value))
		*nearest = (float)*value;
	else
		read_slowly(word, nearest, value);
	return true;
}
