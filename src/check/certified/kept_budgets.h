/* kept_budgets.h - the budget in use, and earlier ones for when the axes come back to where they were. */
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
	int oldest;	/* of those kept, once there is no more room */
};

void kept_budgets_init(struct kept_budgets *budgets, const struct chain *chain);

/* As in budget.h; the budget used until now is kept. */
void kept_budgets_set(struct kept_budgets *budgets, const axis_values *q, const struct chain_state *state, double room);
void kept_budgets_resume(struct kept_budgets *budgets, const axis_values *q);

/*
 * Puts one of those kept into use that covers the straight motion from q0, where the axes
 * stand, to q1. Of it nothing is used up yet.
 */
bool kept_budgets_recall(struct kept_budgets *budgets, const axis_values *q0, const axis_values *q1,
		   const struct position_errors *errors);

/* As in budget.h, with the one in use or else one of those kept, which is in use then. The axes come from q0. */
bool kept_budgets_cover(struct kept_budgets *budgets, const axis_values *q0, const axis_values *q1,
		   const struct position_errors *errors);
bool kept_budgets_cover_box(struct kept_budgets *budgets, const axis_values *low, const axis_values *high,
		       const axis_values *q1, const struct position_errors *errors);

#endif
