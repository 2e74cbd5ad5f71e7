/* axis_table.h - the data of a machine's axes that every move needs, close together in memory. */
#ifndef FIVECHECK_MOTION_AXIS_TABLE_H
#define FIVECHECK_MOTION_AXIS_TABLE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/axes.h"
#include "machine/machine.h"

/* As in struct axis: mm, radians, seconds. */
struct axis_row {
	int slot;
	bool rotary;
	double limit_min, limit_max, rate_max;
};

struct axis_table {
	size_t count;
	struct axis_row rows[SLOT_COUNT];
};

void axis_table_init(struct axis_table *table, const struct machine *machine);

#endif
