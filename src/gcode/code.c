#include "gcode/code.h"

static const struct code *find_in_set(const struct code_set *set, int number)
{
	size_t low = 0, high = set->count;

	if (set->last)
		return number >= set->rows->number && number <= set->last && (number - set->rows->number) % 10 == 0
			   ? set->rows
			   : NULL;
	while (low < high) {
		size_t middle = (low + high) / 2;

		if (set->rows[middle].number < number)
			low = middle + 1;
		else
			high = middle;
	}
	return low < set->count && set->rows[low].number == number ? &set->rows[low] : NULL;
}

const struct code *code_find(const struct code_set *const sets[CODE_SETS_MAX], int number)
{
	const struct code *code = NULL;

	for (int i = 0; i < CODE_SETS_MAX && sets[i] && !code; i++)
		code = find_in_set(sets[i], number);
	return code;
}

bool code_tilts(int number)
{
	return number == G68_2 || number == G68_4;
}

bool code_is_cycle(int number)
{
	return number == G73 || number == G74 || number == G76 || number == G77 || (number >= G81 && number <= G89);
}
