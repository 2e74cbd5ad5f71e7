/* number.h - reads the decimal numbers of NC programs. */
#ifndef FIVECHECK_GCODE_TEXT_NUMBER_H
#define FIVECHECK_GCODE_TEXT_NUMBER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The most bytes of a number without its sign and blanks; LinuxCNC takes lines of 255 bytes. */
#define NUMBER_LENGTH_MAX 255

enum number_status { NUMBER_OK, NUMBER_MISSING, NUMBER_TOO_LONG };

/*
 * Reads [+-] digits [.] digits, with blanks anywhere and no exponent, at text[*position], and moves *position past the
 * number. The value is the double nearest to the decimal number, in every locale; *point: the number has a decimal
 * point.
 */
enum number_status number_read(const char *text, size_t *position, double *value, bool *point);

/* A number of this many digits is below 10^15, and its power of ten is at most 10^15: both are exact as doubles. */
#define NUMBER_USUAL_DIGITS 15

/* First row: 10^i; second row: -10^i. */
extern const double number_power_of_ten[2][NUMBER_USUAL_DIGITS + 1];

/*
 * Appends the digits at `at` to the mantissa, without a check for overflow. *next is the byte after the digits, minus
 * '0'.
 */
static inline const char *number_take_digits(const char *at, uint64_t *mantissa, unsigned *next)
{
	uint64_t value = *mantissa, digit = (unsigned char)*at - (uint64_t)'0';

	while (digit <= 9) {
		value = 10 * value + digit;
		digit = (unsigned char)*++at - (uint64_t)'0';
	}
	*mantissa = value;
	*next = (unsigned)digit;
	return at;
}

/*
 * Reads [+-] digits [.] digits at `text`, without any blank, in one pass; with `comma` a comma may replace the point.
 * Returns the text after the number. NULL: there is no such number, or it has more than NUMBER_USUAL_DIGITS digits, and
 * nothing was set.
 */
static inline const char *number_take_usual(const char *text, bool comma, double *value, bool *point)
{
	const bool negative = *text == '-';
	const char *first = text + (negative || *text == '+'), *end;
	uint64_t mantissa = 0;
	size_t digits, fraction = 0;
	unsigned next;
	bool found;

	end = number_take_digits(first, &mantissa, &next);
	digits = (size_t)(end - first);
	found = next == (unsigned)'.' - '0' || (comma && next == (unsigned)',' - '0');
	if (found) {
		const char *dot = end;

		end = number_take_digits(dot + 1, &mantissa, &next);
		fraction = (size_t)(end - dot) - 1;
		digits += fraction;
	}
	if (digits - 1 >= NUMBER_USUAL_DIGITS)
		return NULL;
	/*
	 * A quotient of two exact doubles is correctly rounded (Clinger, "How to Read Floating Point Numbers
	 * Accurately", 1990). Processors convert signed integers in one step.
	 */
	*value = (double)(int64_t)mantissa / number_power_of_ten[negative][fraction];
	*point = found;
	return end;
}

/*
 * Reads a usual number at `text` in one pass: without blanks inside, and with at most NUMBER_USUAL_DIGITS digits.
 * Returns the text after the number and its blanks. NULL: there is no such number; number_read reads every number.
 */
static inline const char *number_read_usual(const char *text, double *value, bool *point)
{
	const char *end = number_take_usual(text, false, value, point);

	while (end && (*end == ' ' || *end == '\t'))
		end++;
	return end && (unsigned char)(*end - '0') > 9 && *end != '.' ? end : NULL;
}

/* Is there a blank inside a number that was read from start to end? Blanks before and after it do not count. */
bool number_has_blank(const char *text, size_t start, size_t end);

/* Reads [+-] digits [, or .] digits without any blank, like number_read. */
enum number_status number_read_with_comma(const char *text, size_t *position, double *value);

#endif
