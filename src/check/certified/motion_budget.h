/* motion_budget.h - a distance proven once, and the part of it that the axes have used since. */
#ifndef FIVECHECK_CHECK_CERTIFIED_MOTION_BUDGET_H
#define FIVECHECK_CHECK_CERTIFIED_MOTION_BUDGET_H

#include <stdbool.h>

#include "base/axes.h"
#include "check/step.h"
#include "machine/motion_bound.h"

/*
 * At the position `at` two bodies were proven to be farther apart than required, by `room`. While joint k is within x_k
 * of that position no point moves by more than X = sum rho_k x_k, where runs of linear joints count by their vector
 * norm. Every rho_k is the one at `at`: in |E1'E2'p - E1E2p| <= |E2'p - E2p| + |E1'x - E1x| the first term depends only
 * on the later joints, because E1' keeps distances, and in the second, x = E2p has not moved. There the path tolerance
 * t_k moves no point by more than W = sum (rho_k + X) t_k, because the distance of a point from an axis grows by at
 * most X. As long as X + W is below `room` the bodies keep the required distance plus the path displacement
 * (motion_bound.h). The sum is convex in the axes, so a straight motion is covered if both its ends are. There are two
 * views as in motion_bound.h: one of them must cover both ends.
 *
 * If the room is the proven distance minus clearance and tolerance (c + e), the budget covers no motion that the sweep
 * would report: positions that the sweep reports are at most c + e + the path displacement apart, in either view
 * (test_one_verdict).
 */
struct motion_budget {
	const struct chain *chain;
	bool known;
	axis_values at;
	double room;	/* mm */
	double rho[VIEWS][SLOT_COUNT];	/* mm, by joint, at `at` */
	double used[VIEWS];	/* mm, at the current position (the last covered end, or `at`) */
};

void motion_budget_init(struct motion_budget *budget, const struct chain *chain);

/* mm: a budget that begins at the state needs more room than this to cover anything, even the state itself. */
double motion_budget_least(const struct chain *chain, const struct chain_state *state,
			   const struct position_errors *errors);

/*
 * Starts a new budget at q, its current position, with the chain's state `state` there. If room is 0 or less it covers
 * nothing.
 */
void motion_budget_set(struct motion_budget *budget, const axis_values *q, const struct chain_state *state,
		       double room);

/* Makes q the current position, after any motion. */
void motion_budget_resume(struct motion_budget *budget, const axis_values *q);

/* Is the position q covered? */
bool motion_budget_holds(const struct motion_budget *budget, const axis_values *q);

/* Is the straight motion from the budget's current position to q1 covered? If so, q1 becomes the current position. */
bool motion_budget_covers(struct motion_budget *budget, const axis_values *q1, const struct position_errors *errors);

/* The same for every position between low and high. If all are covered, q1 becomes the current position. */
bool motion_budget_covers_box(struct motion_budget *budget, const axis_values *low, const axis_values *high,
			      const axis_values *q1, const struct position_errors *errors);

/*
 * mm: the room that remains at every position between low and high. Below 0, or -INFINITY if there is no budget:
 * nothing is proved there. The current position is unchanged.
 */
double motion_budget_rest(const struct motion_budget *budget, const axis_values *low, const axis_values *high,
			  const struct position_errors *errors);

#endif
