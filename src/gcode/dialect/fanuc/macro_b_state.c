#include "gcode/dialect/fanuc/macro_b_state.h"

#include <math.h>
#include <stdlib.h>

#include "base/mem.h"

double macro_b_vacant(void)
{
	return NAN;
}

void *macro_b_state_new(const struct macro_b_rules *rules)
{
	struct macro_b *macro = mem_zalloc(1, sizeof(*macro));

	macro->rules = rules;
	for (int level = 0; level <= MACRO_B_CALLS_MAX; level++) {
		for (int i = 0; i <= MACRO_B_LOCALS; i++)
			macro->vars.local[level][i] = macro_b_vacant();
	}
	for (int i = 0; i < MACRO_B_COMMON; i++)
		macro->vars.common[i] = macro_b_vacant();
	return macro;
}

void macro_b_state_free(void *state)
{
	struct macro_b *macro = state;

	labels_release(&macro->found);
	free(macro);
}
