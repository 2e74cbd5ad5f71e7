/* limits.h - where a path leaves the travel of the machine's axes. */
#ifndef FIVECHECK_MOTION_LIMITS_H
#define FIVECHECK_MOTION_LIMITS_H

#include <stddef.h>

#include "machine/machine.h"
#include "motion/span.h"

/*
 * A position within 1e-6 mm or degrees of a limit is inside; one past
 * 1.01e-6, on the true motion, is found; between the two either may be said.
 */
struct limit_crossing {
	int slot;
	double bound;	/* the limit, mm or radians */
	double u;	/* the first instant in the path; 0 where it starts outside */
};

/* At most one crossing an axis, in the order of time, then of slots; returns how many. */
size_t limits_crossed(const struct machine *machine, const struct span *whole,
		      struct limit_crossing crossings[SLOT_COUNT]);

#endif
