/*
 * length_check.h - does a tool cut with the length of another one? Then H is wrong, or G43 is missing after a tool
 * change.
 */
#ifndef FIVECHECK_MOTION_LENGTH_CHECK_H
#define FIVECHECK_MOTION_LENGTH_CHECK_H

#include <stdbool.h>

#include "base/diag.h"
#include "gcode/canon.h"
#include "machine/setup.h"

/* All zero: no tool yet. Borrows the setup. */
struct length_check {
	const struct setup *setup;	/* NULL: there is nothing to compare with */
	const struct tool *tool;	/* in the spindle; NULL: none to be checked */
	double last;	/* mm: the last length that was checked; 0: none since the tool change */
	bool told;	/* the warning was given; once per program is enough */
};

/*
 * Another tool is in the spindle. setup may be NULL. Tools that do not cut by turning or are checked="" are left out.
 */
void length_check_tool(struct length_check *check, const struct setup *setup, int tool);

/* length_check_move if there is something to check. */
void length_check_look(struct length_check *check, struct diag *diag, struct srcloc at, double length);

/*
 * A move with this active length. Warns if the spindle turns at feed and the length does not belong to the tool, but to
 * another one. A length of 0 is no compensation.
 */
static inline void length_check_move(struct length_check *check, struct diag *diag, struct srcloc at,
				     const struct canon_move *move)
{
	const double length = move->origin->length;

	if (check->tool && move->kind != CANON_RAPID && move->spindle_turns &&
	    (length < check->last || length > check->last))
		length_check_look(check, diag, at, length);
}

#endif
