/* limits.h - finds the instants at which a move leaves, or may leave, the travel of the machine's axes. */
#ifndef FIVECHECK_MOTION_LIMITS_H
#define FIVECHECK_MOTION_LIMITS_H

#include <stdbool.h>
#include <stddef.h>

#include "machine/machine.h"
#include "motion/axis_table.h"
#include "motion/span.h"

/* Is no axis outside of its limits there? */
static inline bool limits_hold(const struct axis_table *axes, const axis_values *position)
{
	for (size_t i = 0; i < axes->count; i++) {
		const struct axis_row *axis = &axes->rows[i];
		const double at = position->v[axis->slot];

		if (!(at >= axis->limit_min && at <= axis->limit_max))
			return false;
	}
	return true;
}

/*
 * Is every axis certain to stay inside its limits on all legs, including its room (limits_crossed)? False: search
 * crossings. Nearly every move is inside as a whole.
 */
bool limits_kept(const struct axis_table *axes, const struct leg *legs, size_t leg_count, const axis_values *room);

/*
 * A position within 1e-6 mm or degrees of a limit counts as inside. A true position that is more than 1.01e-6 past it
 * is found. Between the two either answer is possible.
 */
struct limit_crossing {
	int slot;
	double bound;	/* the limit, mm or radians */
	bool below;	/* it is the lower one */
	double room;	/* mm, radians: how far the axis may be from its path; 0: the path itself passes the limit */
	size_t leg;
	double u;	/* the first instant in the leg's path; 0: it starts outside */
	double excess;	/* the largest distance of the axis past the limit, to 1e-4 mm or degrees */
};

/*
 * Finds at most one crossing for each axis, in the order of time, then of slots, and returns their number. First come
 * axes whose path passes a limit, then those that may pass one because they may be up to `room` (mm and radians; NULL:
 * 0) from their path.
 */
size_t limits_crossed(const struct machine *machine, const struct leg *legs, size_t leg_count,
		      const axis_values *room, struct limit_crossing crossings[SLOT_COUNT]);

#endif
