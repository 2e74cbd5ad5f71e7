#include "check/budgets.h"

#include "base/ablation.h"

void budgets_init(struct budgets *budgets, const struct chain *chain)
{
	budgets->count = budgets->oldest = 0;
	budget_init(&budgets->now, chain);
}

static void keep(struct budgets *budgets, const struct budget *budget)
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

void budgets_set(struct budgets *budgets, const axis_values *q, const struct chain_state *state, double room)
{
	keep(budgets, &budgets->now);
	budget_set(&budgets->now, q, state, room);
}

void budgets_resume(struct budgets *budgets, const axis_values *q)
{
	budget_resume(&budgets->now, q);
}

/* The i-th kept one goes into use, and what was in use into its place. */
static void take(struct budgets *budgets, int i)
{
	struct budget was = budgets->now;

	budgets->now = budgets->kept[i];
	budgets->kept[i] = was;
}

bool budgets_recall(struct budgets *budgets, const axis_values *q0, const axis_values *q1, const struct position_errors *errors)
{
	for (int i = 0; i < budgets->count; i++) {
		struct budget *budget = &budgets->kept[i];

		/* Where the axes go first: mostly that settles it. */
		if (!budget_holds(budget, q1))
			continue;
		budget_resume(budget, q0);
		if (!budget_covers(budget, q1, errors))
			continue;
		take(budgets, i);
		budgets_resume(budgets, q0);
		return true;
	}
	return false;
}

bool budgets_cover(struct budgets *budgets, const axis_values *q0, const axis_values *q1, const struct position_errors *errors)
{
	return budget_covers(&budgets->now, q1, errors) ||
	       (budgets_recall(budgets, q0, q1, errors) && budget_covers(&budgets->now, q1, errors));
}

bool budgets_cover_box(struct budgets *budgets, const axis_values *low, const axis_values *high,
		       const axis_values *q1, const struct position_errors *errors)
{
	if (budget_covers_box(&budgets->now, low, high, q1, errors))
		return true;
	for (int i = 0; i < budgets->count; i++) {
		if (budget_covers_box(&budgets->kept[i], low, high, q1, errors)) {
			take(budgets, i);
			return true;
		}
	}
	return false;
}
