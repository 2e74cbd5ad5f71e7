/*
 * axis_chains.h - attaches the axes of a machine to its base: one chain carries the work, and one carries the tool.
 * Letters name the axes of a chain, starting at the base.
 */
#ifndef FIVECHECK_IMPORT_AXIS_CHAINS_H
#define FIVECHECK_IMPORT_AXIS_CHAINS_H

#include <stdbool.h>

#include "base/axes.h"
#include "base/diag.h"
#include "import/import.h"

/* The letters of one chain, in upper case. */
struct axis_letters {
	char text[SLOT_COUNT + 1];
};

bool axis_letters_have(const char *letters, char letter);

/* Appends a letter unless it is there already. */
void axis_letters_add(struct axis_letters *letters, char letter);

/* Reads the letters of an option. False, reported: one is not in `axes`, or occurs twice. */
bool axis_letters_read(struct axis_letters *letters, const char *option, const char *asked, const char *axes,
		       struct diag *diag);

/*
 * The axes that carry the tool: those in `asked` (of the option head), which must be all but those of `table`. NULL:
 * linear ones come first, then a rotary one, and U, V and W last. False, reported: `asked` is wrong, or it is NULL and
 * the order of several rotary axes is unknown.
 */
bool axis_letters_head(struct axis_letters *head, const char *asked, const char *axes, const char *table,
		       struct srcloc place, struct diag *diag);

/*
 * Adds both chains. `axes` has one axis for each slot; those of the letters are used. The work is mounted at 0 0 0 on
 * the end of the first chain, and a spindle that points downward at 0 0 0 on the end of the second one.
 */
void axis_chains_hang(struct import_machine *machine, const struct axis_description axes[SLOT_COUNT],
		      const char *table, const char *head);

/* Axes that carry the work move opposite to their letter, because controls count the tool relative to the work. */
vec3 axis_chains_direction(int slot, bool carries_work);

#endif
