#include "gcode/dialect/klartext/cycles/klartext_tolerance.h"

#include <math.h>
#include <string.h>

/*
 * "TOLERANCE (Cycle 32)": T is the largest deviation from the path when the control smooths it; TA is the same for
 * rotary axes, in degrees. Without T the machine's own value is in force again.
 */
bool klartext_tolerance_set(struct interp *interp, const struct klartext_cycle *cycle)
{
	struct state *state = &interp->state;
	bool rotary = cycle->count && cycle->words[0].part > 1;
	double tolerance = rotary ? state->blend_tolerance : 0;

	for (int i = 0; i < cycle->count; i++) {
		const struct klartext_cycle_word *word = &cycle->words[i];

		if (word->given && !strcmp(word->name, "T"))
			tolerance = word->value * state->scale;
		else if (word->given && !strcmp(word->name, "TA") && tolerance > 0)
			tolerance = fmax(tolerance, word->value);
	}
	if (tolerance < 0)
		return fault(&interp->at, cycle->column, "a path tolerance cannot be negative");
	state->blend_tolerance = tolerance;
	return true;
}
