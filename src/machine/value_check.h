/* value_check.h - numbers of an axis that no machine has: rates and travels that look like another unit. */
#ifndef FIVECHECK_MACHINE_VALUE_CHECK_H
#define FIVECHECK_MACHINE_VALUE_CHECK_H

#include "machine/doubt.h"
#include "machine/machine.h"

/* Appends DOUBT_RATE_LOW and DOUBT_RADIANS, axis by axis. Axes that the file marks checked="" are left out. */
void value_check(const struct machine *machine, struct doubts *doubts);

#endif
