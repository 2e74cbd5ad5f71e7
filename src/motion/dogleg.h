/* dogleg.h - a rapid whose axes go each at its own rate until they are there. */
#ifndef FIVECHECK_MOTION_DOGLEG_H
#define FIVECHECK_MOTION_DOGLEG_H

#include <stddef.h>

#include "machine/machine.h"
#include "motion/path.h"

/*
 * Breaks a straight path where an axis arrives: |way| / rate, in the order of these times. The parts are straight, have
 * their seconds, and follow one another without a gap. Returns how many there are; 0: no axis moves.
 */
size_t dogleg_split(const struct machine *machine, const struct path *path, struct path parts[SLOT_COUNT]);

#endif
