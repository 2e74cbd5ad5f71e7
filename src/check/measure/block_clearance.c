#include "check/measure/block_clearance.h"

#include <math.h>

#include "base/ablation.h"
#include "base/minmax.h"
#include "base/same_double.h"
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
 * How often a step is halved until planes last for a part of it. Measured: with 4 an eighth to a 16th of the sweeps are
 * left that are needed without, with 5 half of those again; then most are left where planes do not help at all.
 */
#define HALVINGS 5

/* Where the distances at the ends of a part of a step have at least this ratio, planes are measured in its middle. */
#define ALIKE 0.8

/*
 * After so many chunks the cells of planes are joined again: they were divided where planes of larger parts did not
 * do. Measured: with 16 a tenth more is spent in all, as the planes of the cells are lost; without, nothing is saved.
 */
enum { JOIN_CHUNKS = 256 };

/* A budget that has given nothing for so many steps is forgotten. */
enum { UNSPENT_MOST = 64 };

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

/* Do kept planes keep the bodies more than `needed` mm apart? */
static bool kept_planes_cover(struct block_clearance *block, const struct plane_motion *motion, double needed)
{
	return WITH_PLANES && plane_cells_cover(&block->planes, motion, needed);
}

/* Do planes that are measured at q keep them so far apart? */
static bool new_planes_cover(struct block_clearance *block, const struct plane_motion *motion, const axis_values *q,
			     double needed)
{
	long before = block->planes.visits;
	bool held = plane_cells_search(&block->planes, q, motion, needed);

	plane_account_add_search(&block->account, block->planes.visits - before);
	return held;
}

/* The same for a chunk, if that may pay. */
static bool new_planes_cover_chunk(struct block_clearance *block, const struct plane_motion *motion, double needed)
{
	const axis_values middle = plane_motion_middle(motion);
	bool held;

	if (!WITH_PLANES || !plane_account_allows_chunk(&block->account))
		return false;
	held = new_planes_cover(block, motion, &middle, needed);
	plane_account_add_chunk(&block->account, held);
	return held;
}

/* Were the bodies seen within `most` mm of each other at a position in the box? The last such position is asked for. */
static bool is_seen_near(const struct block_clearance *block, const struct batch_chunk *box, double most)
{
	const struct seen_distance *seen = &block->seen[block->oldest_seen];
	const struct chain *chain = block->bodies.chain;

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
		plane_cells_join(&block->planes);
	if (block->maybe_inside || is_seen_near(block, box, most))
		return false;
	if (motion_budget_rest(&block->budget, &box->low, &box->high, &box->errors) > most)
		return true;
	needed = most + plane_motion_path(&motion, &block->bodies, &box->errors);
	if (!kept_planes_cover(block, &motion, needed) &&
	    !(thorough && new_planes_cover_chunk(block, &motion, needed)))
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

/* mm: what kept planes prove of the motion; they are not asked for more than what is wanted of them. */
static double kept_for(struct block_clearance *block, const struct measured_step *measured,
		       const struct plane_motion *motion)
{
	if (!WITH_PLANES)
		return -INFINITY;
	return plane_cells_rest(&block->planes, motion, wanted_of(block, measured) + measured->path) - measured->path;
}

/* Does a search for planes at q pay, and prove what is wanted of them in this part of the step? */
static bool new_planes_prove(struct block_clearance *block, const struct measured_step *measured,
			     const struct plane_motion *part, const axis_values *q)
{
	const double needed = wanted_of(block, measured) + measured->path;

	/* Of kept planes what they prove is known already, and that other triangles are nearer, too. */
	return WITH_PLANES && plane_account_allows(&block->account) && new_planes_cover(block, part, q, needed);
}

static bool is_at(const struct chain *chain, const axis_values *a, const axis_values *b)
{
	for (size_t i = 0; i < chain->count; i++)
		if (!same_double(a->v[chain->joints[i].slot], b->v[chain->joints[i].slot]))
			return false;
	return true;
}

/* The triangles that were close before, as they were seen at q; NULL: they were not, or are others now. */
static const struct seen_distance *seen_at(const struct block_clearance *block, const axis_values *q)
{
	const struct coherence *coherence = &block->coherence;

	for (int i = 0; i < SEEN_KEPT; i++) {
		const struct seen_distance *seen = &block->seen[i];

		if (seen->known && seen->triangles[0] == coherence->near_a &&
		    seen->triangles[1] == coherence->near_b && is_at(block->bodies.chain, &seen->q, q))
			return seen;
	}
	return NULL;
}

/* mm: how far apart the triangles that were close before are at q: the bodies are no farther apart. */
static double distance_at(struct block_clearance *block, struct measured_step *measured, const axis_values *q)
{
	const struct coherence *coherence = &block->coherence;
	const struct seen_distance *known = seen_at(block, q);
	const double distance = known ? known->distance : near_pair_distance(&block->bodies, q);

	if (!known) {
		block->oldest_seen = (block->oldest_seen + 1) % SEEN_KEPT;
		block->seen[block->oldest_seen] = (struct seen_distance){
			.known = true,
			.q = *q,
			.triangles = {coherence->near_a, coherence->near_b},
			.distance = distance,
		};
	}
	measured->seen = smaller(measured->seen, distance);
	return distance;
}

/*
 * Looks where the triangles that were close before are nearest to each other at the ends of the part, or in its middle
 * if the ends are alike. Stops as soon as what planes prove (`kept`) is all that is wanted of them. Returns the place.
 */
static axis_values look_around(struct block_clearance *block, struct sweep *sweep, struct measured_step *measured,
			       const struct plane_motion *part, double kept)
{
	const double at1 = distance_at(block, measured, &part->q1);
	axis_values nearest = part->q1;
	double at0;

	if (kept > wanted_of(block, measured))
		return nearest;
	at0 = distance_at(block, measured, &part->q0);
	if (kept > wanted_of(block, measured))
		return nearest;
	if (part->straight && smaller(at0, at1) > ALIKE * larger(at0, at1))
		nearest = plane_motion_middle(part);
	else if (at0 < at1)
		nearest = part->q0;
	look_at(block, sweep, measured, &nearest, kept);
	return nearest;
}

/*
 * Do travelling planes prove nearly all that there can be for this part of the step, of which they prove `kept` as it
 * is? What there can be becomes less as nearer triangles are found: those that were nearest before have moved apart as
 * a rule.
 */
static bool planes_prove(struct block_clearance *block, struct sweep *sweep, struct measured_step *measured,
			 const struct plane_motion *part, double kept, int halvings)
{
	axis_values middle, nearest;

	if (kept > wanted_of(block, measured))
		return true;
	nearest = look_around(block, sweep, measured, part, kept);
	if (kept > wanted_of(block, measured))
		return true;
	if (!(wanted_of(block, measured) > 0))
		return false;
	if (new_planes_prove(block, measured, part, &nearest))
		return true;
	if (!part->straight || !halvings)
		return false;
	middle = plane_motion_middle(part);
	for (int half = 0; half < 2; half++) {
		struct plane_motion shorter = *part;

		*(half ? &shorter.q0 : &shorter.q1) = middle;
		if (!planes_prove(block, sweep, measured, &shorter, kept_for(block, measured, &shorter), halvings - 1))
			return false;
	}
	return true;
}

/* Do travelling planes prove as much for the step as the block has, or nearly all there is? They give the bound. */
static bool by_planes(struct block_clearance *block, struct sweep *sweep, struct measured_step *measured)
{
	const struct motion_step *step = measured->step;
	const struct plane_motion motion = {.straight = !step_is_box(step), .q0 = step->span.q0, .q1 = step->span.q1,
					    .chord_error = measured->errors.chord};
	double kept, wanted;

	measured->path = plane_motion_path(&motion, &block->bodies, &measured->errors);
	/* Where the step begins the triangles were seen by every other step: then they need not be looked at where it ends. */
	if (block->is_near)
		distance_at(block, measured, seen_at(block, &motion.q0) ? &motion.q0 : &motion.q1);
	kept = kept_for(block, measured, &motion);
	block->is_near = !(kept > block->bound);
	if (!planes_prove(block, sweep, measured, &motion, kept, WITH_PLANES ? HALVINGS : 0))
		return false;
	wanted = wanted_of(block, measured);
	if (block->accuracy == CLEARANCE_SHARP)
		wanted = larger(wanted, kept > wanted ? kept : kept_for(block, measured, &motion));
	block->bound = smaller(block->bound, wanted);
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
	block->unspent = 0;
	chain_state_init(&state, bodies->chain, q, &bodies->ball_a, &bodies->ball_b);
	motion_budget_set(&block->budget, q, &state, proven);
}

/* Does the budget prove enough for the step, or nearly all that there can be? Then it gives the bound. */
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
	if (!(measured->rest > 0) || (measured->rest <= block->bound && measured->rest < enough(block, most))) {
		block->budget.known = ++block->unspent < UNSPENT_MOST;
		return false;
	}
	block->unspent = 0;
	block->bound = fmin(block->bound, measured->rest);
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
