/* nearest.h - which of the known names a misspelt one was probably meant to be. */
#ifndef FIVECHECK_MACHINE_NEAREST_H
#define FIVECHECK_MACHINE_NEAREST_H

#include <stddef.h>

struct nearest {
	const char *wanted;
	const char *best;	/* NULL: nothing near enough was offered */
	size_t distance;
};

void nearest_init(struct nearest *nearest, const char *wanted);

/*
 * Considers one known name; among equally near ones the first stays. Near
 * enough is one slip (a letter missing, added, wrong, or two exchanged) for
 * every three letters. Both strings are borrowed.
 */
void nearest_offer(struct nearest *nearest, const char *known);

#endif
