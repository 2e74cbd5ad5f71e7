#include "machine/tool_name.h"

#include <math.h>

#include "base/ascii.h"
#include "base/units.h"

/* Names are rounded: 6.35 mm is written 6.4. */
static const double SAME_SHARE = 0.02;

/* The decimal number at *at, with a point or a comma; *at moves past it. */
static double read_decimal(const char **at)
{
	const char *text = *at;
	double value = 0, unit = 1;

	for (; ascii_is_digit(*text); text++)
		value = 10 * value + (*text - '0');
	if ((*text == '.' || *text == ',') && ascii_is_digit(text[1])) {
		for (text++; ascii_is_digit(*text); text++) {
			unit /= 10;
			value += unit * (*text - '0');
		}
	}
	*at = text;
	return value;
}

/* The same with fractions, such as 1/4. */
static double read_number(const char **at)
{
	double value = read_decimal(at), below;

	if (**at != '/' || !ascii_is_digit((*at)[1]))
		return value;
	++*at;
	below = read_decimal(at);
	return below > 0 ? value / below : 0;
}

/* "10 deg" and "10°", in UTF-8 and Latin-1. */
static bool is_angle(const char *behind)
{
	behind += *behind == ' ';
	return ascii_same_start(behind, "deg", 3) || behind[0] == '\xb0' ||
	       (behind[0] == '\xc2' && behind[1] == '\xb0');
}

static bool is_same(double number, double length)
{
	return fabs(number - length) <= SAME_SHARE * length ||
	       fabs(number * MM_PER_INCH - length) <= SAME_SHARE * length;
}

bool tool_name_tells_twice(const struct tool *tool)
{
	bool twice = false;
	int letters = 0;
	char letter = '\0';

	for (const char *at = tool->name; *at && tool->diameter > 0;) {
		double number;

		if (!ascii_is_digit(*at) && !(*at == '.' && ascii_is_digit(at[1]))) {
			/* "D=10" */
			if (*at != '=') {
				letters = ascii_is_letter(*at) ? letters + 1 : 0;
				letter = *at;
			}
			at++;
			continue;
		}
		number = read_number(&at);
		if (is_same(number, tool->diameter))
			return false;
		if ((letters != 1 || letter == 'D' || letter == 'd') && !is_angle(at) &&
		    fabs(number - tool->number) > 0)
			twice |= is_same(number, 2 * tool->diameter);
		letters = 0;
	}
	return twice;
}
