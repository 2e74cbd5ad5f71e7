#include "check/measure/block_clearance.h"

#include <math.h>

#include "base/ablation.h"
#include "check/certified/clearance_query.h"
#include "check/step.h"
#include "geom/moved_tri.h"

/*
 * A distance query asks for this share of the distance. More costs far more than asking whether a distance holds.
 * Only where that is too little for a short step nearly all is asked for: then fewer sweeps follow, which cost more
 * still.
 */
#define DISTANCE_SHARE 0.2
#define SHARP_SHARE 0.95

/* How exactly each query decides, as a share of the distance. */
#define TARGET_SHARE 0.03

/* After so many queries in one step each further query halves the distance. The search normally ends long before. */
#define QUERIES_MAX 60

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
	return 0.9 * distance;
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
	axis_values middle;

	if (block->maybe_inside)
		return false;
	if (motion_budget_rest(&block->budget, low, high, errors) > most)
		return true;
	for (int i = 0; i < SLOT_COUNT; i++)
		middle.v[i] = 0.5 * low->v[i] + 0.5 * high->v[i];
	if (!planes_cover(block, &motion, &middle, most + plane_motion_path(&motion, &block->bodies, errors), true))
		return false;
	plane_account_add_saved(&block->account, steps);
	return true;
}

/* mm: the two triangles that were nearest last are this close at q: the bodies are no farther apart. */
static double distance_seen(const struct block_clearance *block, const axis_values *q)
{
	const struct body_pair *bodies = &block->bodies;
	xform pose = body_pair_pose(bodies, q);
	tri a = tri_of(&bodies->a->mesh, block->coherence.near_a),
	    b = tri_of(&bodies->b->mesh, block->coherence.near_b);
	vec3 on_a, on_b;

	b = tri_transform(&b, &pose);
	return tri_distance(&a, &b, &on_a, &on_b);
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
	return proved / 0.9;
}

/* mm: what is wanted of planes for a step that ends at q, as far as it is known how near the bodies are. */
static double wanted_at(const struct block_clearance *block, const axis_values *q, double path)
{
	return fmin(block->bound, enough(block, distance_seen(block, q) - path));
}

/*
 * Do travelling planes prove as much for the step as the block has, or nearly all that there is? They give the bound.
 * The triangles that were nearest have moved apart as a rule, so that more seems to be possible than is. Nearer ones
 * are looked for until the kept planes are good enough for what they show.
 */
static bool by_planes(struct block_clearance *block, struct sweep *sweep, const struct motion_step *step,
		      const struct position_errors *errors)
{
	const axis_values *q = &step->span.q1;
	const struct plane_motion motion = {.straight = !step_is_box(step), .q0 = step->span.q0, .q1 = *q,
					    .chord_error = errors->chord};
	double path = plane_motion_path(&motion, &block->bodies, errors);
	double kept = plane_cells_rest(&block->planes, &motion) - path;
	double wanted = wanted_at(block, q, path);

	if (kept > 0 && kept < wanted) {
		sweep_distance(sweep, &block->bodies, q, SHARP_SHARE, distance_for(block, kept) + path, 0);
		wanted = wanted_at(block, q, path);
	}
	if (!(wanted > 0) || (!(kept > wanted) && !planes_cover(block, &motion, q, wanted + path, false)))
		return false;
	block->bound = fmin(block->bound, block->accuracy == CLEARANCE_SHARP
					      ? plane_cells_rest(&block->planes, &motion) - path
					      : wanted);
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
static void renew(struct block_clearance *block, struct sweep *sweep, const axis_values *q, double share)
{
	const struct body_pair *bodies = &block->bodies;
	struct chain_state state;
	double proven = sweep_distance(sweep, bodies, q, share, 0, 0);

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
	if (!(*rest > 0) || (*rest <= block->bound && *rest < enough(block, most)))
		return false;
	block->bound = fmin(block->bound, *rest);
	return true;
}

/* The distance to try next, between one that holds (0: none yet) and one that does not. */
static double next_target(const struct block_clearance *block, double low, double high, int failures)
{
	if (block->accuracy != CLEARANCE_SHARP && failures < 4)
		return sqrt(0.95 * high * fmax(low, enough(block, high)));
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
	double target = high < block->bound ? next_target(block, low, high, 0) : block->bound;
	int failures = 0;

	for (int round = 0; low < fmin(enough(block, high), block->bound) && target > tolerance; round++) {
		struct clearance_query query = {sweep, &block->bodies, target, fmax(tolerance, TARGET_SHARE * target),
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
		target = next_target(block, low, high, failures);
	}
	block->bound = low > tolerance ? fmin(block->bound, low) : 0;
}

void block_clearance_step(struct block_clearance *block, struct sweep *sweep, const struct motion_step *step,
			  double tolerance, enum clearance_accuracy accuracy)
{
	const struct position_errors errors = step_errors(block->bodies.chain, step);
	axis_values low, high;
	double rest;
	long before;
	bool held;

	if (!(block->bound > 0))
		return;
	block->accuracy = accuracy;
	step_box(step, &low, &high);
	if (spend(block, &low, &high, &errors, &rest))
		return;
	before = sweep->visits;
	if (by_planes(block, sweep, step, &errors))
		return;
	renew(block, sweep, &step->span.q1, DISTANCE_SHARE);
	held = spend(block, &low, &high, &errors, &rest);
	if (!held && block->accuracy == CLEARANCE_SHARP && SHARP_SHARE * block->found < block->bound) {
		renew(block, sweep, &step->span.q1, SHARP_SHARE);
		held = spend(block, &low, &high, &errors, &rest);
	}
	if (!held)
		prove(block, sweep, step, rest, tolerance);
	plane_account_add_sweep(&block->account, sweep->visits - before);
}
