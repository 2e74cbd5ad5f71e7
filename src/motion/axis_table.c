#include "motion/axis_table.h"

void axis_table_init(struct axis_table *table, const struct machine *machine)
{
	table->count = machine->axis_count;
	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];

		table->rows[i] = (struct axis_row){axis->slot, axis->rotary, axis->limit_min, axis->limit_max,
						   axis->rate_max};
	}
}
