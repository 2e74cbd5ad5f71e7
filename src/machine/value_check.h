/*
 * value_check.h - finds values that no machine has: rates and travels that look like another unit, inaccurate
 * directions.
 */
#ifndef FIVECHECK_MACHINE_VALUE_CHECK_H
#define FIVECHECK_MACHINE_VALUE_CHECK_H

#include "machine/doubt.h"
#include "machine/machine.h"

/*
 * Appends DOUBT_RATE_LOW, DOUBT_RADIANS and DOUBT_TILTED, axis by axis, and DOUBT_SPINDLE_TILTED. Elements marked
 * checked="" are left out.
 */
void value_check(const struct machine *machine, struct doubts *doubts);

#endif
