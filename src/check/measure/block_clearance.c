#include "check/measure/block_clearance.h"

#include <math.h>

#include "check/certified/clearance_query.h"
#include "check/step.h"

/* A distance query asks for this share of the distance. More costs far more than asking whether a distance holds. */
#define DISTANCE_SHARE 0.2

/*
 * The search is done once this share of the smallest distance that was seen is proved. GRAIN: how exactly each query
 * decides, as a share of the distance.
 */
#define ENOUGH 0.9
#define GRAIN 0.03

/* After so many queries in one step each further query halves the distance. The search normally ends long before. */
#define QUERIES_MAX 60

/* The most node pairs to look at for one rapid whose way is not known; then a smaller distance is tried. */
#define BOX_VISITS 1000000L

void block_clearance_init(struct block_clearance *block, const struct body_pair *bodies, double cap)
{
	*block = (struct block_clearance){.bodies = *bodies, .cap = cap, .bound = cap};
	block->bodies.coherence = &block->coherence;
	motion_budget_init(&block->budget, bodies->chain);
}

void block_clearance_start(struct block_clearance *block)
{
	block->bound = block->cap;
}

bool block_clearance_clears(const struct block_clearance *block, const axis_values *low, const axis_values *high,
		  const struct position_errors *errors)
{
	return !block->maybe_inside && motion_budget_rest(&block->budget, low, high, errors) > block->cap;
}

/* Makes a budget at the end of the step, where the next step can use it. */
static void renew(struct block_clearance *block, struct sweep *sweep, const axis_values *q)
{
	const struct body_pair *bodies = &block->bodies;
	struct chain_state state;
	double proven = sweep_distance(sweep, bodies, q, DISTANCE_SHARE, 0, 0);

	block->found = block->coherence.near;
	chain_state_init(&state, bodies->chain, q, &bodies->ball_a, &bodies->ball_b);
	motion_budget_set(&block->budget, q, &state, proven);
}

/* Does the budget prove enough for the step, or nearly all that there can be? Then it gives the bound. */
static bool spend(struct block_clearance *block, const axis_values *low, const axis_values *high,
		  const struct position_errors *errors, double *rest)
{
	double most;

	*rest = motion_budget_rest(&block->budget, low, high, errors);
	most = block->found + (block->budget.room - *rest);
	if (!(*rest > 0) || (*rest <= block->bound && *rest < ENOUGH * most))
		return false;
	block->bound = fmin(block->bound, *rest);
	return true;
}

/* The distance to try next, between one that holds (0: none yet) and one that does not. */
static double next_target(double low, double high, int failures)
{
	if (failures < 2)
		return 0.95 * high;
	return low > 0 ? fmin(sqrt(low * high), 0.95 * high) : 0.5 * high;
}

/*
 * Finds a distance that holds throughout the step. Each failed query shows a smaller distance; the search ends when a
 * proved distance is nearly as large as that.
 */
static void prove(struct block_clearance *block, struct sweep *sweep, const struct motion_step *step, double rest,
		  double tolerance)
{
	double low = fmax(rest, 0), high = block->found;
	double target = high < block->bound ? next_target(low, high, 0) : block->bound;
	int failures = 0;

	for (int round = 0; low < fmin(ENOUGH * high, block->bound) && target > tolerance; round++) {
		struct clearance_query query = {sweep, &block->bodies, target, fmax(tolerance, GRAIN * target),
						true,  BOX_VISITS};
		struct contact contact;
		enum query_answer answer = clearance_query_step(&query, step, &contact);

		if (answer == QUERY_CLEAR) {
			low = target;
		} else if (answer == QUERY_UNDECIDED || round >= QUERIES_MAX) {
			high = target;
			failures = 2;
		} else {
			high = fmin(contact.distance, target + query.tolerance);
			failures++;
		}
		target = next_target(low, high, failures);
	}
	block->bound = low > tolerance ? fmin(block->bound, low) : 0;
}

void block_clearance_step(struct block_clearance *block, struct sweep *sweep, const struct motion_step *step,
			  double tolerance)
{
	const struct position_errors errors = step_errors(block->bodies.chain, step);
	axis_values low, high;
	double rest;

	if (!(block->bound > 0))
		return;
	step_box(step, &low, &high);
	if (spend(block, &low, &high, &errors, &rest))
		return;
	renew(block, sweep, &step->span.q1);
	if (!spend(block, &low, &high, &errors, &rest))
		prove(block, sweep, step, rest, tolerance);
}
