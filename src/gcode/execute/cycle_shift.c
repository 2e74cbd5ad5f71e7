#include "gcode/execute/cycle_shift.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "gcode/execute/cycle_words.h"

static bool find_back_bore(struct canned_cycle *cycle, bool kept)
{
	const struct state *state = &cycle->interp->state;
	double a = 0, b = 0, top = 0;

	if (cycle->code != G87 || cycle->traits->g87 != G87_BACK_BY_IJK)
		return true;
	/* I, J and K belong to X, Y and Z. */
	if (!cycle_words_take(cycle, "IJK"[cycle->a], kept, &a) ||
	    !cycle_words_take(cycle, "IJK"[cycle->b], kept, &b) ||
	    !cycle_words_take(cycle, "IJK"[cycle->depth], kept, &top))
		return false;
	cycle->shift_a = a * state->scale;
	cycle->shift_b = b * state->scale;
	cycle->top = top * state->scale + (state->incremental ? cycle->bottom : state->offset.v[cycle->depth]);
	return true;
}

/* Do I and J give the shift with its direction? A Q of the block, or else of an earlier block, has priority. */
static bool is_shift_by_ij(const struct canned_cycle *cycle, bool kept)
{
	const struct block *block = &cycle->interp->block;
	uint32_t ij = letter_bit('I') | letter_bit('J'), known = kept ? cycle->interp->state.cycle.known : 0;

	if (cycle->traits->shift_by_ij != ANSWER_YES || block_has(block, 'Q'))
		return false;
	return (block->letters & ij) || (!(known & letter_bit('Q')) && (known & ij));
}

/*
 * Finds the distance by which a bore shifts the tool away from the wall. A parameter of the control gives the direction
 * of Q (Fanuc B-64484EN, "Fine Boring Cycle (G76)", parameter 5148; Haas, setting 27): therefore the whole disc around
 * the axis is proved.
 */
static bool find_bore_shift(struct canned_cycle *cycle, bool kept)
{
	struct interp *interp = cycle->interp;
	const struct state *state = &interp->state;
	bool back = cycle_hole_bores_back(cycle);
	int column = block_motion_column(&interp->block), code = cycle->code / 10;
	double q = 0;

	if (cycle->code != G76 && !back)
		return true;
	if (is_shift_by_ij(cycle, kept)) {
		if (state->plane != G17)
			return fault(&interp->at, column,
				     "G%d with I and J is supported only in the plane of G17; give Q",
				     code);
		cycle->shift_a = cycle_words_or_zero(cycle, 'I', kept) * state->scale;
		cycle->shift_b = cycle_words_or_zero(cycle, 'J', kept) * state->scale;
		/* Manuals do not say exactly where a back boring cycle shifts: the disc covers it. */
		cycle->spread = back ? math_hypot(cycle->shift_a, cycle->shift_b) : 0;
	} else if ((!back || cycle->traits->any_order == ANSWER_YES) && !cycle_words_know(cycle, 'Q', kept)) {
		/* The tool enters and leaves on the axis of the hole. */
		if (!interp->cautioned_no_shift)
			caution(&interp->at, column,
				"G%d without Q: it is assumed that the tool %s without a shift, here and further on",
				code,
				back ? "enters and leaves the bore" : "leaves the bore");
		interp->cautioned_no_shift = true;
		return true;
	} else if (!cycle_words_take(cycle, 'Q', kept, &q)) {
		return false;
	} else {
		cycle->spread = fabs(q) * state->scale;
	}
	if (!(cycle->spread > 0))
		return true;
	if (state->tcp != TCP_OFF)
		return fault(&interp->at, column,
			     "G%d with a shift is not supported under tool centre point control",
			     code);
	/* The disc is proved along the path up; without such a path there is no proof. */
	if (!cycle->crosses && !(cycle->clear > (back ? cycle->r : cycle->bottom)))
		return fault(&interp->at, column, "the retract of G%d does not rise from the bottom", code);
	return true;
}

bool cycle_shift_find(struct canned_cycle *cycle, bool kept)
{
	return find_back_bore(cycle, kept) && find_bore_shift(cycle, kept);
}
