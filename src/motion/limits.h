/* limits.h - finds where a path leaves the travel of the machine's axes. */
#ifndef FIVECHECK_MOTION_LIMITS_H
#define FIVECHECK_MOTION_LIMITS_H

#include <stdbool.h>
#include <stddef.h>

#include "machine/machine.h"
#include "motion/span.h"

/*
 * A position within 1e-6 mm or degrees of a limit counts as inside. A true position that is more than 1.01e-6 past it
 * is found. Between the two either answer is possible.
 */
struct limit_crossing {
	int slot;
	double bound;	/* the limit, mm or radians */
	bool below;	/* it is the lower one */
	double u;	/* the first instant in the path; 0: the path starts outside */
};

/* Finds at most one crossing for each axis, in the order of time, then of slots; returns how many. */
size_t limits_crossed(const struct machine *machine, const struct span *whole,
		      struct limit_crossing crossings[SLOT_COUNT]);

/*
 * How far past the crossing's limit the path takes its axis at the farthest, mm or radians, to 1e-4 mm or degrees.
 * Negative: it stays so far inside.
 */
double limits_excess(const struct limit_crossing *crossing, const struct span *whole);

#endif
