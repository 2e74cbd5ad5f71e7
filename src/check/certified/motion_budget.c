#include "check/certified/motion_budget.h"

#include <math.h>

#include "base/ablation.h"
#include "base/minmax.h"

void motion_budget_init(struct motion_budget *budget, const struct chain *chain)
{
	*budget = (struct motion_budget){.chain = chain};
}

void motion_budget_set(struct motion_budget *budget, const axis_values *q, const struct chain_state *state, double room)
{
	budget->known = WITH_BUDGET && room > 0;
	budget->at = *q;
	budget->room = room;
	for (int v = 0; v < VIEWS; v++) {
		budget->used[v] = 0;
		for (size_t i = 0; i < budget->chain->count; i++)
			budget->rho[v][i] = state->rho[v][i];
	}
}

static void use_at(const struct motion_budget *budget, const axis_values *q, double used[VIEWS])
{
	const struct chain *chain = budget->chain;

	used[0] = used[1] = 0;
	for (size_t i = 0; i < chain->count;) {
		const struct joint *joint = &chain->joints[i];

		if (joint->rotary) {
			double turn = fabs(q->v[joint->slot] - budget->at.v[joint->slot]);

			used[0] += budget->rho[0][i] * turn;
			used[1] += budget->rho[1][i] * turn;
			i++;
		} else {
			size_t end = linear_run_end(chain, i);
			double way = linear_way(chain, i, end, &budget->at, q);

			used[0] += way;
			used[1] += way;
			i = end;
		}
	}
}

/* As use_at, for all positions at which each joint differs by at most the given amount. */
static void use_within(const struct motion_budget *budget, const axis_values *amount, double used[VIEWS])
{
	const struct chain *chain = budget->chain;

	used[0] = used[1] = 0;
	for (size_t i = 0; i < chain->count;) {
		double off = amount->v[chain->joints[i].slot];

		if (chain->joints[i].rotary) {
			used[0] += budget->rho[0][i] * off;
			used[1] += budget->rho[1][i] * off;
			i++;
		} else {
			size_t end = linear_run_end(chain, i);
			double way = linear_displacement(chain, i, end, amount);

			used[0] += way;
			used[1] += way;
			i = end;
		}
	}
}

void motion_budget_resume(struct motion_budget *budget, const axis_values *q)
{
	if (budget->known)
		use_at(budget, q, budget->used);
}

bool motion_budget_holds(const struct motion_budget *budget, const axis_values *q)
{
	double used[VIEWS];

	if (!budget->known)
		return false;
	use_at(budget, q, used);
	return smaller(used[0], used[1]) < budget->room;
}

/* Adds to each view's use the use by the errors; `used` is the use by the programmed path. */
static void add_errors(const struct motion_budget *budget, const struct position_errors *errors, double used[VIEWS])
{
	const struct chain *chain = budget->chain;
	double chord[VIEWS], path[VIEWS], turns = 0;

	if (!errors->any)
		return;
	use_within(budget, &errors->chord, chord);
	use_within(budget, &errors->path, path);
	for (size_t i = 0; i < chain->count; i++)
		turns += chain->joints[i].rotary ? errors->path.v[chain->joints[i].slot] : 0;
	for (int v = 0; v < VIEWS; v++)
		used[v] += chord[v] + path[v] + turns * (used[v] + chord[v]);
}

double motion_budget_least(const struct chain *chain, const struct chain_state *state,
			   const struct position_errors *errors)
{
	struct motion_budget budget = {.chain = chain};
	double used[VIEWS] = {0, 0};

	if (!errors->any)
		return 0;
	for (int v = 0; v < VIEWS; v++)
		for (size_t i = 0; i < chain->count; i++)
			budget.rho[v][i] = state->rho[v][i];
	add_errors(&budget, errors, used);
	return smaller(used[0], used[1]);
}

bool motion_budget_covers(struct motion_budget *budget, const axis_values *q1, const struct position_errors *errors)
{
	double used[VIEWS], most[VIEWS];

	if (!budget->known)
		return false;
	use_at(budget, q1, used);
	for (int v = 0; v < VIEWS; v++)
		most[v] = larger(used[v], budget->used[v]);
	add_errors(budget, errors, most);
	if (!(smaller(most[0], most[1]) < budget->room))
		return false;
	budget->used[0] = used[0];
	budget->used[1] = used[1];
	return true;
}

/* As use_within, for every position between low and high. */
static void use_in_box(const struct motion_budget *budget, const axis_values *low, const axis_values *high,
		       const struct position_errors *errors, double used[VIEWS])
{
	axis_values amount;

	for (int i = 0; i < SLOT_COUNT; i++)
		amount.v[i] = larger(fabs(low->v[i] - budget->at.v[i]), fabs(high->v[i] - budget->at.v[i]));
	use_within(budget, &amount, used);
	add_errors(budget, errors, used);
}

bool motion_budget_covers_box(struct motion_budget *budget, const axis_values *low, const axis_values *high,
			      const axis_values *q1, const struct position_errors *errors)
{
	double used[VIEWS];

	if (!budget->known)
		return false;
	use_in_box(budget, low, high, errors, used);
	if (!(smaller(used[0], used[1]) < budget->room))
		return false;
	use_at(budget, q1, budget->used);
	return true;
}

double motion_budget_rest(const struct motion_budget *budget, const axis_values *low, const axis_values *high,
			  const struct position_errors *errors)
{
	double used[VIEWS];

	if (!budget->known)
		return -INFINITY;
	use_in_box(budget, low, high, errors, used);
	return budget->room - fmin(used[0], used[1]);
}
