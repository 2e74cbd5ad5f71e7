#include "check/measure/block_clearance.h"

#include <math.h>

#include "base/ablation.h"
#include "check/certified/clearance_query.h"
#include "check/measure/measured_step.h"
#include "check/step.h"

/*
 * The share of the distance that a distance query must prove. A larger share would cost far more than testing one
 * distance.
 */
#define DISTANCE_SHARE 0.2

/* The tolerance of each query, as a share of the distance. */
#define TARGET_SHARE 0.03

/*
 * After this number of failed queries in one step, the tested distance falls faster. After this number of queries of
 * any kind, each further query halves it. The search normally ends long before.
 */
#define FAILURES_MAX 4
#define QUERIES_MAX 60

/*
 * After this number of chunks the cells of planes are joined again. They were divided where planes of larger parts did
 * not suffice. Measured: with 16 the whole check takes a tenth longer, because the planes of the cells are lost;
 * without joining, nothing is saved.
 */
enum { JOIN_CHUNKS = 256 };

/* A budget that has proved nothing for this number of steps is dropped. */
enum { UNSPENT_MOST = 64 };

/* The largest number of node pairs for one rapid whose path is not known; then a smaller distance is tried. */
#define BOX_VISITS 1000000L

void block_clearance_init(struct block_clearance *block, const struct body_pair *bodies)
{
	*block = (struct block_clearance){.chunks = 0};
	measured_pair_init(&block->pair, bodies);
	motion_budget_init(&block->budget, bodies->chain);
}

void block_clearance_release(struct block_clearance *block)
{
	measured_pair_release(&block->pair);
}

void block_clearance_start(struct block_clearance *block, double most)
{
	block->pair.bound = most;
}

/* Do kept planes keep the bodies more than `needed` mm apart? */
static bool kept_planes_cover(struct block_clearance *block, const struct plane_motion *motion, double needed)
{
	return WITH_PLANES && plane_cells_cover(&block->pair.planes, motion, needed);
}

/* The same with new planes for a whole chunk, if a search for them may pay. */
static bool new_planes_cover_chunk(struct block_clearance *block, const struct plane_motion *motion, double needed)
{
	const axis_values middle = plane_motion_middle(motion);
	const long before = block->pair.planes.visits;
	bool held;

	if (!WITH_PLANES || !plane_account_allows_chunk(&block->pair.account))
		return false;
	held = plane_cells_search(&block->pair.planes, &middle, motion, needed);
	plane_account_add_search(&block->pair.account, block->pair.planes.visits - before);
	plane_account_add_chunk(&block->pair.account, held);
	return held;
}

/* Were the bodies found within `most` mm of each other at a position in the box? Tests the last such position. */
static bool is_seen_near(const struct block_clearance *block, const struct batch_chunk *box, double most)
{
	const struct seen_distance *seen = &block->pair.seen[block->pair.oldest_seen];
	const struct chain *chain = block->pair.bodies.chain;

	if (!seen->known || !(seen->distance <= most))
		return false;
	for (size_t i = 0; i < chain->count; i++) {
		const int slot = chain->joints[i].slot;

		if (seen->q.v[slot] < box->low.v[slot] || seen->q.v[slot] > box->high.v[slot])
			return false;
	}
	return true;
}

bool block_clearance_clears(struct block_clearance *block, const struct batch_chunk *box, double most, size_t steps,
			    bool thorough)
{
	const struct plane_motion motion = {.q0 = box->low, .q1 = box->high, .chord_error = box->errors.chord};
	double needed;

	if (thorough && ++block->chunks % JOIN_CHUNKS == 0)
		plane_cells_join(&block->pair.planes);
	if (block->maybe_inside || is_seen_near(block, box, most))
		return false;
	if (motion_budget_rest(&block->budget, &box->low, &box->high, &box->errors) > most)
		return true;
	needed = most + plane_motion_path(&motion, &block->pair.bodies, &box->errors);
	if (!kept_planes_cover(block, &motion, needed) &&
	    !(thorough && new_planes_cover_chunk(block, &motion, needed)))
		return false;
	plane_account_add_saved(&block->pair.account, steps);
	return true;
}

double block_clearance_look(struct block_clearance *block, struct sweep *sweep, const axis_values *q)
{
	sweep_distance(sweep, &block->pair.bodies, q, DISTANCE_SHARE, 0, 0);
	return block->pair.coherence.near;
}

/* Makes a budget at the end of the step, where the next step can use it. */
static void renew(struct block_clearance *block, struct sweep *sweep, const axis_values *q)
{
	const struct body_pair *bodies = &block->pair.bodies;
	struct chain_state state;
	double proven = sweep_distance(sweep, bodies, q, DISTANCE_SHARE, 0, 0);

	block->found = block->pair.coherence.near;
	block->unspent = 0;
	chain_state_init(&state, bodies->chain, q, &bodies->ball_a, &bodies->ball_b);
	motion_budget_set(&block->budget, q, &state, proven);
}

/* mm: the search ends when this distance is proved. */
static double enough(const struct block_clearance *block, double distance)
{
	return clearance_accuracy_enough(block->pair.accuracy, distance, block->pair.bound);
}

/* Does the budget prove enough for the step, or nearly the whole distance? Then it sets the bound. */
static bool spend(struct block_clearance *block, struct measured_step *measured)
{
	axis_values low, high;
	double most;

	measured->rest = -INFINITY;
	if (!block->budget.known)
		return false;
	step_box(measured->step, &low, &high);
	measured->rest = motion_budget_rest(&block->budget, &low, &high, &measured->errors);
	most = block->found + (block->budget.room - measured->rest);
	if (!(measured->rest > 0) || (measured->rest <= block->pair.bound && measured->rest < enough(block, most))) {
		block->budget.known = ++block->unspent < UNSPENT_MOST;
		return false;
	}
	block->unspent = 0;
	block->pair.bound = fmin(block->pair.bound, measured->rest);
	return true;
}

/* The distance to try next, between one that holds (0: none yet) and one that does not. */
static double next_target(const struct block_clearance *block, double low, double high, int failures)
{
	if (failures < FAILURES_MAX)
		return sqrt(0.95 * high * fmax(low, enough(block, high)));
	return low > 0 ? fmin(sqrt(low * high), 0.95 * high) : 0.5 * high;
}

/*
 * Finds a distance that holds throughout the step. Each failed query lowers the upper bound; the search ends when the
 * proved distance is close enough to this bound.
 */
static void prove(struct block_clearance *block, struct sweep *sweep, const struct measured_step *measured,
		  double tolerance)
{
	double low = fmax(measured->rest, 0), high = fmin(measured->seen, block->found);
	double target = high < block->pair.bound ? next_target(block, low, high, 0) : block->pair.bound;
	int failures = 0;

	for (int round = 0; low < fmin(enough(block, high), block->pair.bound) && target > tolerance; round++) {
		const struct clearance_query query = {
			.sweep = sweep,
			.bodies = &block->pair.bodies,
			.clearance = target,
			.tolerance = fmax(tolerance, TARGET_SHARE * target),
			.any = true,
			.box_visits = BOX_VISITS,
		};
		struct contact contact;
		enum query_answer answer = clearance_query_step(&query, measured->step, &contact);

		if (answer == QUERY_CLEAR) {
			low = target;
		} else if (answer == QUERY_UNDECIDED || round >= QUERIES_MAX) {
			high = target;
			failures = FAILURES_MAX;
		} else {
			high = fmin(contact.distance, target + query.tolerance);
			failures++;
		}
		target = next_target(block, low, high, failures);
	}
	block->pair.bound = low > tolerance ? fmin(block->pair.bound, low) : 0;
}

void block_clearance_step(struct block_clearance *block, struct sweep *sweep, const struct motion_step *step,
			  double tolerance, enum clearance_accuracy accuracy)
{
	struct measured_step measured;
	long before;

	if (!(block->pair.bound > 0))
		return;
	block->pair.accuracy = accuracy;
	measured_step_init(&measured, &block->pair, step);
	if (spend(block, &measured))
		return;
	before = sweep->visits;
	if (measured_step_by_planes(&measured, &block->pair, sweep))
		return;
	renew(block, sweep, &step->span.q1);
	if (!spend(block, &measured))
		prove(block, sweep, &measured, tolerance);
	plane_account_add_sweep(&block->pair.account, sweep->visits - before);
}
