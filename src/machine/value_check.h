/*
 * value_check.h - numbers that no machine has: rates and travels in what looks like another unit, slips of directions.
 */
#ifndef FIVECHECK_MACHINE_VALUE_CHECK_H
#define FIVECHECK_MACHINE_VALUE_CHECK_H

#include "machine/doubt.h"
#include "machine/machine.h"

/*
 * Appends DOUBT_RATE_LOW, DOUBT_RADIANS and DOUBT_TILTED, axis by axis, and DOUBT_SPINDLE_TILTED. What the file marks
 * checked="" is left out.
 */
void value_check(const struct machine *machine, struct doubts *doubts);

#endif
