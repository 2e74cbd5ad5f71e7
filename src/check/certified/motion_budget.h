/* motion_budget.h - a distance proven once, and how much of it the axes have used up since. */
#ifndef FIVECHECK_CHECK_CERTIFIED_MOTION_BUDGET_H
#define FIVECHECK_CHECK_CERTIFIED_MOTION_BUDGET_H

#include <stdbool.h>

#include "base/axes.h"
#include "check/step.h"
#include "machine/motion_bound.h"

/*
 * At the position `at` two bodies were proven to be farther apart than what they must keep by `room`. While joint k is
 * within x_k of that position no point moves by more than X = sum rho_k x_k, runs of linear joints by their vector
 * norm. Every rho_k is the one at `at`: of |E1'E2'p - E1E2p| <= |E2'p - E2p| + |E1'x - E1x| the first term is the
 * later joints' alone, as E1' keeps distances, and in the second x = E2p stands where it was. There the path
 * tolerance t_k moves no point by more than W = sum (rho_k + X) t_k, since a point's distance to an axis
 * grows by at most X. As long as X + W is below `room` the bodies keep what they must keep, and the path displacement
 * (motion_bound.h) besides. The sum is convex in the axes, so a straight motion is covered when both its ends are.
 * Two views as in motion_bound.h: one of them must cover both ends.
 *
 * A budget whose room is the proven distance less clearance and tolerance (c + e) covers no motion that the sweep would
 * report: what the sweep reports is at most c + e + the path displacement apart, in either view (test_one_verdict).
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
 * Starts a new budget at q, its current position, where the chain's state is `state`. If room is 0 or less it covers
 * nothing.
 */
void motion_budget_set(struct motion_budget *budget, const axis_values *q, const struct chain_state *state,
		       double room);

/* Makes q the current position, whatever the motion to q was. */
void motion_budget_resume(struct motion_budget *budget, const axis_values *q);

/* Is the position q covered? */
bool motion_budget_holds(const struct motion_budget *budget, const axis_values *q);

/* Is the straight motion from the budget's current position to q1 covered? If so q1 is its current position. */
bool motion_budget_covers(struct motion_budget *budget, const axis_values *q1, const struct position_errors *errors);

/* The same for every position between low and high. If all are covered, q1 is the current position. */
bool motion_budget_covers_box(struct motion_budget *budget, const axis_values *low, const axis_values *high,
		       const axis_values *q1, const struct position_errors *errors);

/*
 * mm: the room that is left at every position between low and high. Below 0, or -INFINITY if there is no budget:
 * nothing is proved there. The current position stays.
 */
double motion_budget_rest(const struct motion_budget *budget, const axis_values *low, const axis_values *high,
		   const struct position_errors *errors);

#endif
