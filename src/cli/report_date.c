#include "cli/report_date.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

/* The end of the year 9999. */
#define EPOCH_MAX 253402300799LL

static bool read_epoch(time_t *out, const char *text)
{
	size_t digits = strspn(text, "0123456789");
	long long seconds = digits && digits < 13 && !text[digits] ? strtoll(text, NULL, 10) : -1;

	if (seconds < 0 || seconds > EPOCH_MAX)
		return false;
	*out = (time_t)seconds;
	return true;
}

bool report_date_get(char out[DATE_SIZE], struct diag *diag)
{
	const char *epoch = getenv("SOURCE_DATE_EPOCH");
	time_t now = time(NULL);
	struct tm day;

	if (epoch && *epoch && !read_epoch(&now, epoch)) {
		diag_error(diag, (struct srcloc){0},
			   "SOURCE_DATE_EPOCH is '%s', which is not a number of seconds since 1970", epoch);
		return false;
	}
	if (!gmtime_r(&now, &day) || strftime(out, DATE_SIZE, "%Y-%m-%d", &day) != DATE_SIZE - 1) {
		diag_error(diag, (struct srcloc){0}, "the clock of this computer has no valid date");
		return false;
	}
	return true;
}
