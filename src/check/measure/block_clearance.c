#include "check/measure/block_clearance.h"

#include <math.h>

#include "base/ablation.h"
#include "check/certified/clearance_query.h"
#include "check/step.h"
#include "scene/near_pair.h"

/* A distance query asks for this share of the distance. More costs far more than asking whether a distance holds. */
#define DISTANCE_SHARE 0.2

/*
 * Of a sharp bound: this share of the distance is enough. Measured: 0.9 takes a sixth longer. But where the distance is
 * so many times what the block has, only that is enough: a report tells where the whole cap holds.
 */
#define SHARP_ENOUGH 0.87
#define SHARP_BEYOND 1.1

/* How exactly each query decides, as a share of the distance. */
#define TARGET_SHARE 0.03

/*
 * After so many queries that fail in one step the distance that is tried next falls faster. After so many of any kind
 * each further query halves it. The search normally ends long before.
 */
#define FAILURES_MAX 4
#define QUERIES_MAX 60

/*
 * How often a step is halved until planes last for a part of it. Measured: with 4 an eighth to a 16th of the sweeps are left that are
 * needed without; then most of those are left where planes do not help at all.
 */
#define HALVINGS 4

/* The most node pairs to look at for one rapid whose way is not known; then a smaller distance is tried. */
#define BOX_VISITS 1000000L

void block_clearance_init(struct block_clearance *block, const struct body_pair *bodies)
{
	*block = (struct block_clearance){.bodies = *bodies};
	block->bodies.coherence = &block->coherence;
	motion_budget_init(&block->budget, bodies->chain);
	plane_cells_init(&block->planes, &block->bodies);
	plane_account_init(&block->account, bodies->a->mesh.count + bodies->b->mesh.count);
}

void block_clearance_release(struct block_clearance *block)
{
	plane_cells_release(&block->planes);
}

void block_clearance_start(struct block_clearance *block, double most)
{
	block->bound = most;
}

/*
 * mm: the search is done once as much is proved and the bodies are no farther apart than `distance` mm. A little above
 * what is promised, for what rounding and TARGET_SHARE take.
 */
static double enough(const struct block_clearance *block, double distance)
{
	switch (block->accuracy) {
	case CLEARANCE_SHARP:
		break;
	case CLEARANCE_COARSE:
		return fmin(0.65 * distance, fmax(distance - 0.25, 0.3 * distance));
	case CLEARANCE_ROUGH:
		return 0.12 * distance;
	}
	return fmax(SHARP_ENOUGH * distance, distance > SHARP_BEYOND * block->bound ? block->bound : 0);
}

/* Do travelling planes keep the bodies more than `needed` mm apart? New ones are measured at q if that may pay. */
static bool planes_cover(struct block_clearance *block, const struct plane_motion *motion, const axis_values *q,
			 double needed, bool chunk)
{
	long before = block->planes.visits;
	bool held;

	if (!WITH_PLANES)
		return false;
	held = plane_cells_cover(&block->planes, motion, needed);
	if (held || !(chunk ? plane_account_allows_chunk(&block->account) : plane_account_allows(&block->account)))
		return held;
	held = plane_cells_search(&block->planes, q, motion, needed);
	plane_account_add_search(&block->account, block->planes.visits - before);
	if (chunk)
		plane_account_add_chunk(&block->account, held);
	return held;
}

bool block_clearance_clears(struct block_clearance *block, const axis_values *low, const axis_values *high,
			    const struct position_errors *errors, size_t steps, double most)
{
	const struct plane_motion motion = {.q0 = *low, .q1 = *high, .chord_error = errors->chord};
	const axis_values middle = plane_motion_middle(&motion);

	if (block->maybe_inside)
		return false;
	if (motion_budget_rest(&block->budget, low, high, errors) > most)
		return true;
	if (!planes_cover(block, &motion, &middle, most + plane_motion_path(&motion, &block->bodies, errors), true))
		return false;
	plane_account_add_saved(&block->account, steps);
	return true;
}

/* mm: the distance of which `proved` is just enough. */
static double distance_for(const struct block_clearance *block, double proved)
{
	switch (block->accuracy) {
	case CLEARANCE_SHARP:
		break;
	case CLEARANCE_COARSE:
		return fmax(proved / 0.65, fmin(proved + 0.25, proved / 0.3));
	case CLEARANCE_ROUGH:
		return proved / 0.12;
	}
	return proved / SHARP_ENOUGH;
}

/* A step whose smallest distance is looked for. */
struct measured_step {
	const struct motion_step *step;
	struct position_errors errors;
	axis_values low, high;	/* of its ends */
	double path;	/* mm: no path displacement is larger */
	double seen;	/* mm: two triangles were this close somewhere on it: the bodies are no farther apart */
	double rest;	/* mm: what the budget proves */
};

static void measured_step_init(struct measured_step *measured, const struct block_clearance *block,
			       const struct motion_step *step)
{
	measured->step = step;
	measured->errors = step_errors(block->bodies.chain, step);
	measured->path = 0;
	measured->seen = INFINITY;
	step_box(step, &measured->low, &measured->high);
}

/* mm: what is wanted of planes, as far as it is known how near the bodies come. */
static double wanted_of(const struct block_clearance *block, const struct measured_step *measured)
{
	return fmin(block->bound, enough(block, measured->seen - measured->path));
}

/* Looks for triangles that are near each other at q. If planes have proved `kept`, others than those are of no use. */
static void look_at(struct block_clearance *block, struct sweep *sweep, struct measured_step *measured,
		    const axis_values *q, double kept)
{
	const double useful = kept > 0 ? distance_for(block, kept) + measured->path : 0;

	measured->seen = fmin(measured->seen, near_pair_improve(&block->bodies, q, useful, &sweep->visits));
}

/*
 * Do travelling planes prove nearly all that there can be for this part of the step? What there can be becomes less
 * as nearer triangles are found: those that were nearest before have moved apart as a rule.
 */
static bool planes_prove(struct block_clearance *block, struct sweep *sweep, struct measured_step *measured,
			 const struct plane_motion *part, int halvings)
{
	const axis_values middle = plane_motion_middle(part);
	const double kept = plane_cells_rest(&block->planes, part) - measured->path;

	if (kept > wanted_of(block, measured))
		return true;
	look_at(block, sweep, measured, part->straight ? &middle : &part->q1, kept);
	if (kept > wanted_of(block, measured))
		return true;
	if (!(wanted_of(block, measured) > 0))
		return false;
	if (planes_cover(block, part, &middle, wanted_of(block, measured) + measured->path, false))
		return true;
	if (!part->straight || !halvings)
		return false;
	for (int half = 0; half < 2; half++) {
		struct plane_motion shorter = *part;

		*(half ? &shorter.q0 : &shorter.q1) = middle;
		if (!planes_prove(block, sweep, measured, &shorter, halvings - 1))
			return false;
	}
	return true;
}

/* Do travelling planes prove as much for the step as the block has, or nearly all that there is? They give the bound. */
static bool by_planes(struct block_clearance *block, struct sweep *sweep, struct measured_step *measured)
{
	const struct motion_step *step = measured->step;
	const struct plane_motion motion = {.straight = !step_is_box(step), .q0 = step->span.q0, .q1 = step->span.q1,
					    .chord_error = measured->errors.chord};
	double wanted;

	measured->path = plane_motion_path(&motion, &block->bodies, &measured->errors);
	measured->seen = fmin(near_pair_distance(&block->bodies, &step->span.q0),
			      near_pair_distance(&block->bodies, &step->span.q1));
	if (!WITH_PLANES || !planes_prove(block, sweep, measured, &motion, HALVINGS))
		return false;
	wanted = wanted_of(block, measured);
	if (block->accuracy == CLEARANCE_SHARP)
		wanted = fmax(wanted, plane_cells_rest(&block->planes, &motion) - measured->path);
	block->bound = fmin(block->bound, wanted);
	plane_account_add_saved(&block->account, 1);
	return true;
}

double block_clearance_promised(enum clearance_accuracy accuracy, double distance)
{
	switch (accuracy) {
	case CLEARANCE_SHARP:
		break;
	case CLEARANCE_COARSE:
		return fmin(0.6 * distance, fmax(distance - 0.3, 0.25 * distance));
	case CLEARANCE_ROUGH:
		return 0.1 * distance;
	}
	return 0.85 * distance;
}

double block_clearance_look(struct block_clearance *block, struct sweep *sweep, const axis_values *q)
{
	sweep_distance(sweep, &block->bodies, q, DISTANCE_SHARE, 0, 0);
	return block->coherence.near;
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
static bool spend(struct block_clearance *block, struct measured_step *measured)
{
	const double rest = motion_budget_rest(&block->budget, &measured->low, &measured->high, &measured->errors);
	const double most = block->found + (block->budget.room - rest);

	measured->rest = rest;
	if (!(rest > 0) || (rest <= block->bound && rest < enough(block, most)))
		return false;
	block->bound = fmin(block->bound, rest);
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
 * Finds a distance that holds throughout the step. Each failed query shows a smaller distance; the search ends when a
 * proved distance is nearly as large as that.
 */
static void prove(struct block_clearance *block, struct sweep *sweep, const struct measured_step *measured,
		  double tolerance)
{
	double low = fmax(measured->rest, 0), high = fmin(measured->seen, block->found);
	double target = high < block->bound ? next_target(block, low, high, 0) : block->bound;
	int failures = 0;

	for (int round = 0; low < fmin(enough(block, high), block->bound) && target > tolerance; round++) {
		struct clearance_query query = {sweep, &block->bodies, target, fmax(tolerance, TARGET_SHARE * target),
						true,  BOX_VISITS};
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
	block->bound = low > tolerance ? fmin(block->bound, low) : 0;
}

void block_clearance_step(struct block_clearance *block, struct sweep *sweep, const struct motion_step *step,
			  double tolerance, enum clearance_accuracy accuracy)
{
	struct measured_step measured;
	long before;

	if (!(block->bound > 0))
		return;
	block->accuracy = accuracy;
	measured_step_init(&measured, block, step);
	if (spend(block, &measured))
		return;
	before = sweep->visits;
	if (by_planes(block, sweep, &measured))
		return;
	renew(block, sweep, &step->span.q1);
	if (!spend(block, &measured))
		prove(block, sweep, &measured, tolerance);
	plane_account_add_sweep(&block->account, sweep->visits - before);
}
