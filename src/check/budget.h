/* budget.h - a distance proven once, and how much of it the axes have used up since. */
#ifndef FIVECHECK_CHECK_BUDGET_H
#define FIVECHECK_CHECK_BUDGET_H

#include <stdbool.h>

#include "base/axes.h"
#include "machine/motion_bound.h"
#include "scene/region.h"

/*
 * At the position `at` two bodies were proven to be farther apart than their
 * clearance by `room`. While joint k is within x_k of that position no point
 * moves by more than sum rho_k x_k, runs of linear joints by their vector norm,
 * and as long as that is below `room` they stay apart. Every rho_k is the one at
 * `at`: of |E1'E2'p - E1E2p| <= |E2'p - E2p| + |E1'x - E1x| the first term is the
 * later joints' alone, as E1' keeps distances, and in the second x = E2p stands where it
 * was. The sum is convex in the axes, so a straight motion is covered when both
 * its ends are. Two views as in motion_bound.h: one of them must cover both ends.
 */
struct budget {
	const struct chain *chain;
	bool known;
	axis_values at;
	double room;	/* mm */
	double rho[VIEWS][SLOT_COUNT];	/* mm, by joint, at `at` */
	double used[VIEWS];	/* mm, at the end of the last motion that was covered or at `at` */
};

void budget_init(struct budget *budget, const struct chain *chain);

/* Starts anew at q with the state of the chain there; room may be 0 or less: then it covers nothing. */
void budget_set(struct budget *budget, const axis_values *q, const struct chain_state *state, double room);

/* The axes stand at q again without having been followed from `at`. */
void budget_resume(struct budget *budget, const axis_values *q);

/* Is q covered? */
bool budget_holds(const struct budget *budget, const axis_values *q);

/*
 * Is the motion from where the budget was last used to q1 covered, when each
 * axis may be off by `off` (mm, radians; NULL: exact)? If so it is used.
 */
bool budget_covers(struct budget *budget, const axis_values *q1, const axis_values *off);

/* The same for every position between low and high, after which the axes stand at q1. */
bool budget_covers_box(struct budget *budget, const axis_values *low, const axis_values *high,
		       const axis_values *q1, const axis_values *off);

/*
 * mm of the room that are left wherever between low and high the axes stand; below 0, or
 * -INFINITY when nothing is known: nothing is proven there. Uses nothing up.
 */
double budget_rest(const struct budget *budget, const axis_values *low, const axis_values *high,
		   const axis_values *off);

#endif
