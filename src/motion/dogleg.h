/* dogleg.h - a rapid in which each axis moves at its own rate until it arrives. */
#ifndef FIVECHECK_MOTION_DOGLEG_H
#define FIVECHECK_MOTION_DOGLEG_H

#include <stddef.h>

#include "machine/machine.h"
#include "motion/path.h"

/*
 * Divides a straight path at the times when axes arrive, |distance| / rate. The parts are straight, have their seconds,
 * and follow one another without a gap. Returns their number; 0: no axis moves.
 */
size_t dogleg_split(const struct machine *machine, const struct path *path, struct path parts[SLOT_COUNT]);

#endif
