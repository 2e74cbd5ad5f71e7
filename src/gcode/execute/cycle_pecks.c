#include "gcode/execute/cycle_pecks.h"

#include <float.h>
#include <math.h>

#include "base/same_double.h"
#include "gcode/execute/cycle_words.h"

/* Haas, "G73", "G83": the first peck is I, each further peck is smaller by J, and no peck is smaller than K. */
static bool find_falling_peck(struct canned_cycle *cycle, bool kept)
{
	struct interp *interp = cycle->interp;
	double first = 0, less = 0, least = 0, scale = interp->state.scale;

	if (!cycle_words_take(cycle, 'I', kept, &first) || !cycle_words_take(cycle, 'J', kept, &less) ||
	    !cycle_words_take(cycle, 'K', kept, &least))
		return false;
	cycle->peck = fabs(first) * scale;
	cycle->peck_less = fabs(less) * scale;
	cycle->peck_least = fabs(least) * scale;
	if (!(cycle->peck > 0) || !(cycle->peck_least > 0))
		return fault(&interp->at, block_motion_column(&interp->block), "I and K of G%d must be greater than 0",
			     cycle->code / 10);
	return true;
}

/* All pecks are on the path between R and the bottom, whatever their depths. */
static void drill_in_one_stroke(struct canned_cycle *cycle)
{
	cycle->peck = cycle->peck_least = cycle->crosses ? 0 : cycle->r - cycle->bottom + 1;
}

static bool check_pecks(struct canned_cycle *cycle, int column, double q)
{
	struct interp *interp = cycle->interp;

	if (cycle->crosses)
		return true;
	if ((cycle->r - cycle->bottom) / cycle->peck_least > CYCLE_COUNT_MAX)
		return fault(&interp->at, column, "Q%g of G%d makes more than %d pecks", q, cycle->code / 10,
			     CYCLE_COUNT_MAX);
	/* Rounding would make such a peck 0, and the pecks would never reach the bottom. */
	if (cycle->peck_least < DBL_EPSILON * fmax(fabs(cycle->r), fabs(cycle->bottom)))
		return fault(&interp->at, column, "Q%g of G%d is too small for the number format at this height", q,
			     cycle->code / 10);
	return true;
}

bool cycle_pecks_find(struct canned_cycle *cycle, bool kept)
{
	struct interp *interp = cycle->interp;
	int column =
	    block_has(&interp->block, 'Q') ? block_column(&interp->block, 'Q') : block_motion_column(&interp->block);
	double q = 0;

	/* Fanuc B-64484EN, "Peck Rigid Tapping Cycle": Q is kept; the pecks and their retracts are on the same path. */
	if (cycle->code == G74 || cycle->code == G84)
		return !block_has(&interp->block, 'Q') || cycle_words_take(cycle, 'Q', kept, &q);
	if (cycle->code != G73 && cycle->code != G83)
		return true;
	if (cycle->traits->pecks_fall == ANSWER_YES && !block_has(&interp->block, 'Q') &&
	    cycle_words_know(cycle, 'I', kept))
		return find_falling_peck(cycle, kept) && check_pecks(cycle, column, cycle->peck);
	if (cycle->traits->q_has_sign == ANSWER_NO && !cycle_words_know(cycle, 'Q', kept)) {
		drill_in_one_stroke(cycle);
		return true;
	}
	if (!cycle_words_take(cycle, 'Q', kept, &q))
		return false;
	if (cycle->traits->q_has_sign == ANSWER_NO && same_double(q, 0)) {
		drill_in_one_stroke(cycle);
		return true;
	}
	cycle->peck = (cycle->traits->q_has_sign == ANSWER_YES ? q : fabs(q)) * interp->state.scale;
	if (!(cycle->peck > 0))
		return fault(&interp->at, column, "Q of G%d must be greater than 0", cycle->code / 10);
	cycle->peck_least = cycle->peck;
	return check_pecks(cycle, column, q);
}
