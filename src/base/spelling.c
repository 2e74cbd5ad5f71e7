#include "base/spelling.h"

#include <stdbool.h>
#include <string.h>

#include "base/ascii.h"

/* For longer names there is no suggestion. */
#define LONGEST ((size_t)64)

static size_t least(size_t a, size_t b)
{
	return a < b ? a : b;
}

static bool same_letter(char a, char b)
{
	return ascii_lower(a) == ascii_lower(b);
}

/* Levenshtein's distance, with two exchanged neighbours as one error; upper and lower case are equal. */
static size_t distance(const char *a, size_t na, const char *b, size_t nb)
{
	size_t rows[3][LONGEST + 1];
	size_t *before = rows[0], *last = rows[1], *row = rows[2];

	for (size_t j = 0; j <= nb; j++)
		last[j] = j;
	for (size_t i = 1; i <= na; i++) {
		size_t *spare = before;

		row[0] = i;
		for (size_t j = 1; j <= nb; j++) {
			size_t wrong = last[j - 1] + !same_letter(a[i - 1], b[j - 1]);

			row[j] = least(wrong, least(last[j], row[j - 1]) + 1);
			if (i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1]))
				row[j] = least(row[j], before[j - 2] + 1);
		}
		before = last;
		last = row;
		row = spare;
	}
	return last[nb];
}

void spelling_init(struct spelling *spelling, const char *wanted)
{
	*spelling = (struct spelling){.wanted = wanted};
}

void spelling_offer(struct spelling *spelling, const char *known)
{
	size_t wanted_length = strlen(spelling->wanted), known_length = strlen(known);
	size_t slips;

	if (wanted_length > LONGEST || known_length > LONGEST)
		return;
	slips = distance(spelling->wanted, wanted_length, known, known_length);
	if (slips > (wanted_length + 2) / 3 || slips >= known_length)
		return;
	if (!spelling->best || slips < spelling->distance) {
		spelling->best = known;
		spelling->distance = slips;
	}
}
