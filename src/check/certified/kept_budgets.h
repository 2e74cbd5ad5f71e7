/*
 * kept_budgets.h - the motion budget in use, and earlier ones, which help when the axes come back to the same places.
 */
#ifndef FIVECHECK_CHECK_CERTIFIED_KEPT_BUDGETS_H
#define FIVECHECK_CHECK_CERTIFIED_KEPT_BUDGETS_H

#include "check/certified/motion_budget.h"

/* Measured: 8 are nearly as good, 64 no better; looking through them costs more the more there are. */
enum { BUDGETS_KEPT = 16 };

/*
 * Every budget is a region of joint space without a contact. Programs go to and fro: the last few regions
 * together often hold all that follows. (Quinlan's bubbles, Stanford 1994, are such regions for planning motions.)
 */
struct kept_budgets {
	struct motion_budget now;
	struct motion_budget kept[BUDGETS_KEPT];
	int count;
	int oldest;	/* the kept budget to replace next, once BUDGETS_KEPT are kept */
};

void kept_budgets_init(struct kept_budgets *budgets, const struct chain *chain);

/* As in motion_budget.h. kept_budgets_set also keeps the budget that was in use. */
void kept_budgets_set(struct kept_budgets *budgets, const axis_values *q, const struct chain_state *state, double room);
void kept_budgets_resume(struct kept_budgets *budgets, const axis_values *q);

/*
 * If a kept budget covers the straight motion from q0, where the axes stand, to q1, it becomes the one in use. None of
 * it is used up yet.
 */
bool kept_budgets_recall(struct kept_budgets *budgets, const axis_values *q0, const axis_values *q1,
		   const struct position_errors *errors);

/*
 * As in motion_budget.h, with the budget in use; if that does not cover the motion, with a kept one, which is in use
 * from then on: for a box only with `recall`. The axes come from q0.
 */
bool kept_budgets_cover(struct kept_budgets *budgets, const axis_values *q0, const axis_values *q1,
		   const struct position_errors *errors);
bool kept_budgets_cover_box(struct kept_budgets *budgets, const axis_values *low, const axis_values *high,
		       const axis_values *q1, const struct position_errors *errors, bool recall);

#endif
