#include "machine/offset_name.h"

#include <stdio.h>
#include <string.h>

/* The whole number from least to most in the text, or -1. Leading zeros are not permitted. */
static int read_number(const char *text, int least, int most)
{
	const size_t digits = strspn(text, "0123456789");
	int number = 0;

	if (digits == 0 || digits > 4 || text[digits] || (text[0] == '0' && digits > 1))
		return -1;
	for (size_t i = 0; i < digits; i++)
		number = number * 10 + (text[i] - '0');
	return number >= least && number <= most ? number : -1;
}

/* The number after the code and its P: 7 of "G54.1 P7" and "G54.1P7". -1: the name has another form. */
static int read_p(const char *name, const char *code, int most)
{
	const size_t length = strlen(code);
	const char *rest = name + length;

	if (strncmp(name, code, length) != 0)
		return -1;
	rest += strspn(rest, " ");
	return *rest == 'P' ? read_number(rest + 1, 1, most) : -1;
}

/* P of G54.1, in any spelling, or -1. */
static int read_additional(const char *name)
{
	static const char *const codes[] = {"G54.1", "G54", "G154"};
	const int code = name[0] == 'G' ? read_number(name + 1, 110, 129) : -1;

	for (size_t i = 0; i < sizeof(codes) / sizeof(codes[0]); i++) {
		const int number = read_p(name, codes[i], i < 2 ? 300 : 99);

		if (number > 0)
			return number;
	}
	return code > 0 ? code - 109 : -1;
}

static bool is_plain(const char *name)
{
	static const char *const names[] = {"G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"};

	for (size_t i = 0; i < sizeof(names) / sizeof(names[0]); i++) {
		if (!strcmp(name, names[i]))
			return true;
	}
	return (name[0] == 'G' && read_number(name + 1, 505, 599) > 0) ||
	       (name[0] == '#' && read_number(name + 1, 0, 9999) >= 0);
}

bool offset_name_read(const char *name, char read[OFFSET_NAME_SIZE])
{
	const int additional = read_additional(name), correction = read_p(name, "G54.4", 7);

	if (additional > 0)
		snprintf(read, OFFSET_NAME_SIZE, "G54.1 P%d", additional);
	else if (correction > 0)
		snprintf(read, OFFSET_NAME_SIZE, "G54.4 P%d", correction);
	else if (is_plain(name))
		snprintf(read, OFFSET_NAME_SIZE, "%s", name);
	else
		return false;
	return true;
}
