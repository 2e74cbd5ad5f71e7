#include "check/measure/stock_clearance.h"

#include <math.h>
#include <stdlib.h>

#include "base/mem.h"
#include "base/minmax.h"
#include "check/step.h"

/*
 * The search in a step ends when the proved distance is at least this share of a distance that the body does not keep.
 * It is not begun if a budget proves nearly all of its room. A larger share would cost far more: a wall that remains
 * all around a shank is examined in cells that are small compared with the undecided distance (0.9 takes six times as
 * long as 0.7).
 */
#define ENOUGH 0.7
#define BUDGET_ENOUGH 0.9

/* A distance query stops at cells that are this small compared with their distance. */
#define CELL_SHARE 0.2

/* The most cells examined for one distance in one step; then a smaller distance is tried. */
#define SWEEP_EFFORT 200000L

/* A budget may prove this multiple of the cap, so that it holds for some steps. */
#define BUDGET_CAPS 2

void stock_clearance_init(struct stock_clearance *clearance, struct stock_pair *pair, double cap)
{
	*clearance = (struct stock_clearance){.pair = pair, .cap = cap};
	motion_budget_init(&clearance->budget, pair->bodies.chain);
}

void stock_clearance_release(struct stock_clearance *clearance)
{
	free(clearance->blocks);
	*clearance = (struct stock_clearance){.pair = NULL};
}

/* mm: the distance that the budget proves for the whole step. */
static double budget_rest(const struct stock_clearance *clearance, const struct motion_step *step)
{
	const struct position_errors errors = step_errors(clearance->pair->bodies.chain, step);
	axis_values low, high;

	step_box(step, &low, &high);
	return motion_budget_rest(&clearance->budget, &low, &high, &errors);
}

/* Begins a budget at the end of the step, with the stock before the step: later the stock is smaller. */
static void renew_budget(struct stock_clearance *clearance, const struct motion_step *step, long number)
{
	const struct stock_pair *pair = clearance->pair;
	const axis_values *q = &step->span.q1;
	const struct placed_obstacle placed = stock_sweep_place(&pair->sweep, q);
	const struct distance_query query = {.enough = BUDGET_CAPS * clearance->cap, .share = CELL_SHARE,
					     .by_parts = true};
	const double distance = stock_cells_distance(pair->sweep.cells, &placed, (double)number, &query);
	struct chain_state state;

	chain_state_init(&state, pair->bodies.chain, q, &pair->bodies.ball_a, &pair->bodies.ball_b);
	motion_budget_set(&clearance->budget, q, &state,
			  distance - body_pair_rounding(&pair->bodies, q, placed.to_obstacle.translation));
}

/* Does the body keep this distance during the whole step? */
static bool keeps(struct stock_clearance *clearance, const struct motion_step *step, long number, double distance)
{
	struct stock_sweep sweep = clearance->pair->sweep;
	struct contact contact;
	bool apart;

	sweep.clearance = distance;
	sweep.effort = SWEEP_EFFORT;
	sweep.exhausted = false;
	apart = stock_pair_sweep(clearance->pair, &sweep, step, number, &contact) == QUERY_CLEAR;
	clearance->pair->sweep.broken_off |= sweep.broken_off;
	return apart;
}

/* Lowers the bound to the distance that the body keeps in the step, which is at least `low`. */
static void search_distance(struct stock_clearance *clearance, const struct motion_step *step, long number, double low)
{
	const double least = clearance->pair->sweep.least_way;
	double high = clearance->bound, target = high;

	while (low < ENOUGH * high && high > least && !clearance->pair->sweep.broken_off) {
		if (keeps(clearance, step, number, target))
			low = target;
		else
			high = target;
		/* Always between both, or the search would not end. A small proved distance is a poor guide. */
		target = larger(sqrt(low * high), low > least ? 0 : 0.5 * high);
	}
	clearance->bound = low > least ? smaller(clearance->bound, low) : 0;
}

static void measure_step(struct stock_clearance *clearance, const struct motion_step *step, long number)
{
	double rest = budget_rest(clearance, step);

	if (!(clearance->bound > 0) || rest >= clearance->bound)
		return;
	renew_budget(clearance, step, number);
	rest = budget_rest(clearance, step);
	if (rest >= clearance->bound)
		return;
	if (rest >= BUDGET_ENOUGH * clearance->budget.room)
		clearance->bound = rest;
	else
		search_distance(clearance, step, number, larger(rest, 0));
}

static void start_block(struct stock_clearance *clearance, long block)
{
	if (clearance->block_count && clearance->blocks[clearance->block_count - 1].block == block)
		return;
	clearance->blocks = mem_grow(clearance->blocks, &clearance->block_capacity, clearance->block_count + 1,
				     sizeof(*clearance->blocks));
	clearance->blocks[clearance->block_count++] = (struct stock_block_clearance){block, clearance->cap};
	clearance->bound = clearance->cap;
}

bool stock_clearance_measure(struct stock_clearance *clearance, const struct batch *batch)
{
	const struct stock_pair *pair = clearance->pair;
	bool clears = false;

	clearance->block_count = 0;
	for (size_t i = 0; i < batch->step_count && pair->watch.steps == STEP_ANY && !pair->sweep.broken_off; i++) {
		const struct batch_step *step = &batch->steps[i];
		const struct batch_chunk *chunk = &batch->chunks[i / CHUNK_STEPS];

		if (i % CHUNK_STEPS == 0)
			clears = motion_budget_rest(&clearance->budget, &chunk->low, &chunk->high, &chunk->errors) >=
				 clearance->cap;
		if (pair->watch.past_limits_only && !step->beyond)
			continue;
		start_block(clearance, step->block);
		if (!clears)
			measure_step(clearance, &step->motion, step->number);
		clearance->blocks[clearance->block_count - 1].clearance = clearance->bound;
	}
	return !pair->sweep.broken_off;
}
