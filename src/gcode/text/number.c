#include "gcode/text/number.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/ascii.h"

/* 10^22 is the last power of ten that a double holds exactly. */
#define EXACT_POWER_MAX 22
#define EXACT_MANTISSA_MAX ((uint64_t)1 << 53)
#define MANTISSA_DIGITS_MAX 19

static const double power_of_ten[EXACT_POWER_MAX + 1] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
							 1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
							 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

const double number_power_of_ten[2][NUMBER_USUAL_DIGITS + 1] = {
    {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15},
    {-1e0, -1e1, -1e2, -1e3, -1e4, -1e5, -1e6, -1e7, -1e8, -1e9, -1e10, -1e11, -1e12, -1e13, -1e14, -1e15}};

static bool is_blank(char c)
{
	return c == ' ' || c == '\t';
}

/* Writes the number as an integer with an exponent, which strtod reads in the same way in every locale. */
static double slow_value(const char *text, size_t begin, size_t end, int fraction_digits)
{
	char clean[NUMBER_LENGTH_MAX + 16];
	size_t length = 0;

	for (size_t i = begin; i < end; i++) {
		if (ascii_is_digit(text[i]))
			clean[length++] = text[i];
	}
	snprintf(clean + length, sizeof(clean) - length, "e-%d", fraction_digits);
	return strtod(clean, NULL);
}

/* The value of a number with all digits in the mantissa: a quotient of two exact doubles is correctly rounded. */
static bool exact_value(uint64_t mantissa, int fraction_digits, double *value)
{
	/* Clinger, "How to Read Floating Point Numbers Accurately", 1990. */
	if (mantissa > EXACT_MANTISSA_MAX || fraction_digits > EXACT_POWER_MAX)
		return false;
	/* Processors convert signed integers in one step. */
	*value = (double)(int64_t)mantissa / power_of_ten[fraction_digits];
	return true;
}

/* Reads every number. */
static enum number_status read_slowly(const char *text, size_t *position, double *value, bool *point)
{
	size_t at = *position, begin;
	uint64_t mantissa = 0;
	int digits = 0, significant = 0, fraction_digits = 0;
	bool negative = false, seen_point = false;

	while (is_blank(text[at]))
		at++;
	if (text[at] == '+' || text[at] == '-')
		negative = text[at++] == '-';
	for (begin = at;; at++) {
		char c = text[at];

		if (ascii_is_digit(c)) {
			digits++;
			fraction_digits += seen_point;
			significant += significant > 0 || c != '0';
			if (significant <= MANTISSA_DIGITS_MAX)
				mantissa = 10 * mantissa + (uint64_t)(c - '0');
		} else if (c == '.' && !seen_point) {
			seen_point = true;
		} else if (!is_blank(c)) {
			break;
		}
	}
	if (digits == 0)
		return NUMBER_MISSING;
	if (digits > NUMBER_LENGTH_MAX)
		return NUMBER_TOO_LONG;
	if (significant > MANTISSA_DIGITS_MAX || !exact_value(mantissa, fraction_digits, value))
		*value = slow_value(text, begin, at, fraction_digits);
	if (negative)
		*value = -*value;
	*point = seen_point;
	*position = at;
	return NUMBER_OK;
}

enum number_status number_read(const char *text, size_t *position, double *value, bool *point)
{
	const char *end = number_read_usual(text + *position, value, point);

	if (!end)
		return read_slowly(text, position, value, point);
	*position = (size_t)(end - text);
	return NUMBER_OK;
}

/* Reads every number of number_read_with_comma. */
static enum number_status read_slowly_with_comma(const char *text, size_t *position, double *value)
{
	const char *first = text + *position + (text[*position] == '-' || text[*position] == '+'), *at, *end;
	uint64_t mantissa = 0;
	int digits, fraction_digits = 0;
	unsigned next;
	double size;

	at = end = number_take_digits(first, &mantissa, &next);
	digits = (int)(at - first);
	if (*at == '.' || *at == ',') {
		end = number_take_digits(at + 1, &mantissa, &next);
		fraction_digits = (int)(end - at) - 1;
	}
	if (digits + fraction_digits == 0)
		return NUMBER_MISSING;
	if (end - first > NUMBER_LENGTH_MAX)
		return NUMBER_TOO_LONG;
	if (digits + fraction_digits > MANTISSA_DIGITS_MAX || !exact_value(mantissa, fraction_digits, &size))
		size = slow_value(text, (size_t)(first - text), (size_t)(end - text), fraction_digits);
	*value = text[*position] == '-' ? -size : size;
	*position = (size_t)(end - text);
	return NUMBER_OK;
}

enum number_status number_read_with_comma(const char *text, size_t *position, double *value)
{
	bool point;
	const char *end = number_take_usual(text + *position, true, value, &point);

	if (!end)
		return read_slowly_with_comma(text, position, value);
	*position = (size_t)(end - text);
	return NUMBER_OK;
}

bool number_has_blank(const char *text, size_t start, size_t end)
{
	while (start < end && is_blank(text[start]))
		start++;
	while (end > start && is_blank(text[end - 1]))
		end--;
	while (start < end && !is_blank(text[start]))
		start++;
	return start < end;
}
