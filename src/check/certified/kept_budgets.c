#include "check/certified/kept_budgets.h"

#include "base/ablation.h"

void kept_budgets_init(struct kept_budgets *budgets, const struct chain *chain)
{
	budgets->count = budgets->oldest = 0;
	motion_budget_init(&budgets->now, chain);
}

static void keep_budget(struct kept_budgets *budgets, const struct motion_budget *budget)
{
	if (!WITH_KEPT_BUDGETS || !budget->known)
		return;
	if (budgets->count < BUDGETS_KEPT) {
		budgets->kept[budgets->count++] = *budget;
		return;
	}
	budgets->kept[budgets->oldest] = *budget;
	budgets->oldest = (budgets->oldest + 1) % BUDGETS_KEPT;
}

void kept_budgets_set(struct kept_budgets *budgets, const axis_values *q, const struct chain_state *state, double room)
{
	keep_budget(budgets, &budgets->now);
	motion_budget_set(&budgets->now, q, state, room);
}

void kept_budgets_resume(struct kept_budgets *budgets, const axis_values *q)
{
	motion_budget_resume(&budgets->now, q);
}

/* Swaps the i-th kept budget with the one in use. */
static void use_kept(struct kept_budgets *budgets, int i)
{
	struct motion_budget was = budgets->now;

	budgets->now = budgets->kept[i];
	budgets->kept[i] = was;
}

bool kept_budgets_recall(struct kept_budgets *budgets, const axis_values *q0, const axis_values *q1,
			 const struct position_errors *errors)
{
	for (int i = 0; i < budgets->count; i++) {
		struct motion_budget *budget = &budgets->kept[i];

		/* The end of the motion decides most cases, so test it first. */
		if (!motion_budget_holds(budget, q1))
			continue;
		motion_budget_resume(budget, q0);
		if (!motion_budget_covers(budget, q1, errors))
			continue;
		use_kept(budgets, i);
		kept_budgets_resume(budgets, q0);
		return true;
	}
	return false;
}

bool kept_budgets_cover(struct kept_budgets *budgets, const axis_values *q0, const axis_values *q1,
			const struct position_errors *errors)
{
	return motion_budget_covers(&budgets->now, q1, errors) ||
	       (kept_budgets_recall(budgets, q0, q1, errors) && motion_budget_covers(&budgets->now, q1, errors));
}

bool kept_budgets_cover_box(struct kept_budgets *budgets, const axis_values *low, const axis_values *high,
			    const axis_values *q1, const struct position_errors *errors, bool recall)
{
	if (motion_budget_covers_box(&budgets->now, low, high, q1, errors))
		return true;
	for (int i = 0; recall && i < budgets->count; i++) {
		if (motion_budget_covers_box(&budgets->kept[i], low, high, q1, errors)) {
			use_kept(budgets, i);
			return true;
		}
	}
	return false;
}
