/* spelling.h - finds the known name that a misspelt one probably means. */
#ifndef FIVECHECK_BASE_SPELLING_H
#define FIVECHECK_BASE_SPELLING_H

#include <stddef.h>

struct spelling {
	const char *wanted;
	const char *best;	/* NULL: no name was near enough */
	size_t distance;
};

void spelling_init(struct spelling *spelling, const char *wanted);

/*
 * Considers one known name; among equally near ones the first stays. Near enough is one slip (a letter missing, added,
 * wrong, or two exchanged) for every three letters. Both strings are borrowed.
 */
void spelling_offer(struct spelling *spelling, const char *known);

#endif
