/*
 * kept_budgets.h - the current motion budget, and earlier ones, which help when the axes return to the same places.
 */
#ifndef FIVECHECK_CHECK_CERTIFIED_KEPT_BUDGETS_H
#define FIVECHECK_CHECK_CERTIFIED_KEPT_BUDGETS_H

#include "check/certified/motion_budget.h"

/* Measured: 8 are nearly as good, 64 no better. The cost of searching them grows with their number. */
enum { BUDGETS_KEPT = 16 };

/*
 * Every budget is a region of joint space without a contact. Programs move to and fro, so the last few regions together
 * often contain all of the following motion. (Quinlan's bubbles, Stanford 1994, are such regions for motion planning.)
 */
struct kept_budgets {
	struct motion_budget now;
	struct motion_budget kept[BUDGETS_KEPT];
	int count;
	int oldest;	/* the kept budget to replace next, once BUDGETS_KEPT are kept */
};

void kept_budgets_init(struct kept_budgets *budgets, const struct chain *chain);

/* As in motion_budget.h. kept_budgets_set also keeps the budget that was current until then. */
void kept_budgets_set(struct kept_budgets *budgets, const axis_values *q, const struct chain_state *state, double room);
void kept_budgets_resume(struct kept_budgets *budgets, const axis_values *q);

/*
 * If a kept budget covers the straight motion from the current position q0 to q1, it becomes the current one. None of
 * it is used up yet.
 */
bool kept_budgets_recall(struct kept_budgets *budgets, const axis_values *q0, const axis_values *q1,
			 const struct position_errors *errors);

/*
 * As in motion_budget.h, with the current budget. If it does not cover the motion, kept ones are tried, and one that
 * does becomes the current one; for a box only with `recall`. The axes come from q0.
 */
bool kept_budgets_cover(struct kept_budgets *budgets, const axis_values *q0, const axis_values *q1,
			const struct position_errors *errors);
bool kept_budgets_cover_box(struct kept_budgets *budgets, const axis_values *low, const axis_values *high,
			    const axis_values *q1, const struct position_errors *errors, bool recall);

#endif
