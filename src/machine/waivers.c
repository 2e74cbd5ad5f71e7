#include "machine/waivers.h"

#include <string.h>

#include <stdlib.h>

void waivers_free(struct waivers *waivers)
{
	if (!waivers)
		return;
	arena_release(&waivers->arena);
	free(waivers);
}

bool waivers_is_date(const char *text)
{
	static const int lengths[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
	static const char form[] = "dddd-dd-dd";
	long year, month, day;

	if (strlen(text) != DATE_SIZE - 1)
		return false;
	for (int i = 0; form[i]; i++)
		if (form[i] == 'd' ? text[i] < '0' || text[i] > '9' : text[i] != form[i])
			return false;
	year = strtol(text, NULL, 10);
	month = strtol(text + 5, NULL, 10);
	day = strtol(text + 8, NULL, 10);
	if (month < 1 || month > 12 || day < 1 || year < 1)
		return false;
	return day <= lengths[month - 1] + (month == 2 && (year % 400 == 0 || (year % 4 == 0 && year % 100 != 0)));
}
