#include "check/certified/strategy.h"

#include <math.h>

#include "base/ablation.h"
#include "check/certified/merged_steps.h"
#include "check/step.h"
#include "geom/corner_runs.h"

/*
 * The first distance query for a budget asks for this share of the true distance. Measured: 0.3 to 0.45 perform alike;
 * 0.15 takes a tenth longer.
 */
#define BUDGET_SHARE 0.3

/*
 * A second, sharper distance query asks for this share of the true distance. It is used when the first query proved too
 * little although the distance of two triangles exceeds what is needed by more than SHARP_NEED times the way of the
 * step. It may visit as many node pairs as the sweeps did since the last such query. Measured: 0.35 to 0.5 perform
 * alike.
 */
#define SHARP_SHARE 0.5
#define SHARP_NEED 2

/* A query was worth its time if the room that it proves is more than this many times the way of the step. */
#define PAYING_ROOM 4

/*
 * If the smallest clearance is measured and a target fails, the next target is this share of the part beyond the
 * clearance. The coarse share is for the curve of a report. Measured: the coarse share saves a seventh of the check
 * where bodies slide along each other, and a smaller share saves nothing more.
 */
#define MEASURE_SHARE 0.7
#define COARSE_MEASURE_SHARE 0.5

/*
 * After queries that did not pay, at most this number of steps are swept until the next query. Measured: 64 cost a
 * tenth more where bodies are near each other.
 */
#define BACKOFF_MAX 256

/*
 * Steps are merged if the second-order term and the chord errors take at most this share of the distance. Measured:
 * 0.05 to 0.1 perform alike; 1 costs four times as much where bodies turn fast close to each other.
 */
#define CHORD_ERROR_SHARE 0.1

/* The largest number of halvings of a step to find parts for which planes hold. */
#define HALVINGS 4

/*
 * The number of nodes for the first search for planes: all corners of the mesh for their runs, or only the nodes that
 * make its profile (profile.h; measured: 4,500 nodes of a ball).
 */
static size_t first_look(const struct bvh *bvh)
{
	return bvh->mesh.count <= RUN_MESH_TRIANGLES ? bvh->mesh.count : 4000;
}

void strategy_init(struct strategy *strategy, const struct body_pair *bodies, double clearance, double tolerance,
		   enum strategy_measure measure)
{
	*strategy = (struct strategy){.distance_pays = true};
	pair_proof_init(&strategy->proof, bodies, clearance, tolerance);
	plane_account_init(&strategy->planes, first_look(bodies->a) + first_look(bodies->b));
	if (measure == STRATEGY_PROVES)
		return;
	strategy->measure_share = measure == STRATEGY_MEASURES ? MEASURE_SHARE : COARSE_MEASURE_SHARE;
	strategy->proof.target = INFINITY;
}

void strategy_cap(struct strategy *strategy, double most)
{
	pair_proof_aim(&strategy->proof, most);
}

void strategy_release(struct strategy *strategy)
{
	pair_proof_release(&strategy->proof);
}

void strategy_fork(const struct strategy *whole, struct strategy *part)
{
	*part = *whole;
	pair_proof_copy(&part->proof, &whole->proof);
	part->covered_steps = part->plane_steps = part->queries = 0;
	strategy_forget_position(part);
}

void strategy_join(struct strategy *whole, struct strategy *part)
{
	struct pair_proof proof = whole->proof;
	long covered_steps = whole->covered_steps + part->covered_steps, queries = whole->queries + part->queries;
	long plane_steps = whole->plane_steps + part->plane_steps;
	double target = fmin(whole->proof.target, part->proof.target);

	*whole = *part;
	whole->proof = proof;
	pair_proof_take(&whole->proof, &part->proof);
	whole->covered_steps = covered_steps;
	whole->plane_steps = plane_steps;
	whole->queries = queries;
	pair_proof_aim(&whole->proof, target);
}

double strategy_proven(const struct strategy *strategy)
{
	return strategy->proof.target;
}

void strategy_limit_boxes(struct strategy *strategy, int halvings)
{
	strategy->proof.box_halvings = halvings;
}

void strategy_forget_position(struct strategy *strategy)
{
	pair_proof_forget_position(&strategy->proof);
}

static bool is_measuring_first(const struct strategy *strategy)
{
	return isinf(strategy->proof.target);
}

static bool covered(struct strategy *strategy, const struct motion_step *step, const struct position_errors *errors)
{
	if (!pair_proof_step_by_budget(&strategy->proof, step, errors))
		return false;
	strategy->covered_steps++;
	strategy->distance_pays = true;
	return true;
}

/* mm: the approximate relative motion of the bodies in the step. A budget with less room does not cover the step. */
static double way_of(const struct chain *chain, const struct chain_state *state, const struct span *span)
{
	double way = 0;

	for (size_t i = 0; i < chain->count; i++) {
		double dq = fabs(span->q1.v[chain->joints[i].slot] - span->q0.v[chain->joints[i].slot]);

		way += chain->joints[i].rotary ? dq * fmin(state->rho[0][i], state->rho[1][i]) : dq;
	}
	return way;
}

/*
 * mm: a lower bound of the distance at q. A coarse query comes first, then a sharp one if it may pay (SHARP_SHARE). A
 * distance of up to `needed` mm is not useful.
 */
static double ask_distance(struct strategy *strategy, struct sweep *sweep, const axis_values *q, double needed,
			   double way)
{
	const struct pair_proof *proof = &strategy->proof;
	double enough = needed + way;
	double distance = sweep_distance(sweep, &proof->bodies, q, BUDGET_SHARE, enough, 0);

	strategy->queries++;
	if (!WITH_KEPT_BUDGETS || strategy->sweep_visits <= 0 || distance - needed > PAYING_ROOM * way ||
	    !(proof->coherence.near - needed > SHARP_NEED * way))
		return distance;
	distance = fmax(distance,
			sweep_distance(sweep, &proof->bodies, q, SHARP_SHARE, enough, strategy->sweep_visits));
	strategy->queries++;
	strategy->sweep_visits = 0;
	return distance;
}

/* The same with the accuracy of the smallest clearance; the first such distance sets the target. */
static double measure_distance(struct strategy *strategy, struct sweep *sweep, const axis_values *q, double enough)
{
	struct pair_proof *proof = &strategy->proof;
	bool first = is_measuring_first(strategy);
	double distance = sweep_distance(sweep, &proof->bodies, q, strategy->measure_share,
					 first ? proof->clearance : enough, 0);

	strategy->queries++;
	if (first)
		pair_proof_aim(proof, strategy->measure_share * distance);
	return distance;
}

/* Queries the distance at the end of the step and starts a new budget with it. */
static void renew(struct strategy *strategy, struct sweep *sweep, const struct motion_step *step,
		  const struct position_errors *errors)
{
	struct pair_proof *proof = &strategy->proof;
	const struct body_pair *bodies = &proof->bodies;
	const struct span *span = &step->span;
	struct chain_state state;
	double way, lost, distance;

	chain_state_init(&state, bodies->chain, &span->q1, &bodies->ball_a, &bodies->ball_b);
	way = way_of(bodies->chain, &state, span);
	/*
	 * The use by the path tolerance counts for sharp queries only: coarse ones are cheap even if no room is left.
	 */
	lost = strategy->measure_share > 0 ? motion_budget_least(bodies->chain, &state, errors) : 0;
	distance = strategy->measure_share > 0
			   ? measure_distance(strategy, sweep, &span->q1, pair_proof_needed(proof) + lost + way)
			   : ask_distance(strategy, sweep, &span->q1, pair_proof_needed(proof), way);
	pair_proof_add_distance(proof, &span->q1, &state, distance);
	if (distance - pair_proof_needed(proof) - lost > PAYING_ROOM * way) {
		strategy->backoff = 1;
	} else {
		strategy->steps_to_next_query = strategy->backoff;
		strategy->backoff = strategy->backoff < BACKOFF_MAX ? 2 * strategy->backoff + 1 : BACKOFF_MAX;
	}
}

/* Can travelling planes help? Not before the first target is measured. */
static bool uses_planes(const struct strategy *strategy)
{
	return WITH_PLANES && !is_measuring_first(strategy);
}

/* Uses the kept planes, or new ones if a search for them may pay. */
static bool covered_by_planes(struct strategy *strategy, const struct motion_step *step,
			      const struct position_errors *errors)
{
	struct pair_proof *proof = &strategy->proof;
	long before = proof->planes.visits;
	bool held;

	if (!uses_planes(strategy))
		return false;
	held = pair_proof_step_by_planes(proof, step, errors, false);
	if (!held && plane_account_allows(&strategy->planes)) {
		held = pair_proof_step_by_planes(proof, step, errors, true);
		plane_account_add_search(&strategy->planes, proof->planes.visits - before);
	}
	if (held) {
		plane_account_add_saved(&strategy->planes, 1);
		strategy->plane_steps++;
	}
	return held;
}

/*
 * Do other planes for each part of the step make its sweep unnecessary? As long as such searches fail, fewer and fewer
 * steps are halved.
 */
static bool halves_by_planes(struct strategy *strategy, const struct motion_step *step,
			     const struct position_errors *errors)
{
	struct pair_proof *proof = &strategy->proof;
	long before = proof->planes.visits;
	bool held;

	if (!uses_planes(strategy) || !plane_account_allows_halves(&strategy->planes))
		return false;
	held = pair_proof_halves_by_planes(proof, step, errors, HALVINGS);
	plane_account_add_search(&strategy->planes, proof->planes.visits - before);
	plane_account_add_halves(&strategy->planes, held);
	if (held) {
		plane_account_add_saved(&strategy->planes, 1);
		strategy->plane_steps++;
	}
	return held;
}

static enum query_answer sweep_step(struct strategy *strategy, struct sweep *sweep, const struct motion_step *step,
				    struct contact *contact)
{
	long before = sweep->visits;
	enum query_answer answer = pair_proof_step(&strategy->proof, sweep, step, contact);

	strategy->sweep_visits += sweep->visits - before;
	plane_account_add_sweep(&strategy->planes, sweep->visits - before);
	return answer;
}

/*
 * Does a distance query show at once that a target beyond the clearance fails? The query costs far less than a sweep
 * with the same result. *contact then has the distance of two triangles at the end of the step.
 */
static bool is_target_missed(struct strategy *strategy, struct sweep *sweep, const struct motion_step *step,
			     struct contact *contact)
{
	struct pair_proof *proof = &strategy->proof;

	if (!(proof->target > proof->clearance) || is_measuring_first(strategy))
		return false;
	sweep_distance(sweep, &proof->bodies, &step->span.q1, BUDGET_SHARE, proof->target, 0);
	strategy->queries++;
	contact->distance = proof->coherence.near;
	return contact->distance <= proof->target;
}

/* Tries to prove the step for the current target. */
static enum query_answer attempt(struct strategy *strategy, struct sweep *sweep, const struct motion_step *step,
				 struct contact *contact)
{
	struct pair_proof *proof = &strategy->proof;
	struct position_errors errors;
	enum query_answer answer;

	if (pair_proof_still(proof, step))
		return QUERY_CLEAR;
	errors = step_errors(proof->bodies.chain, step);
	if (covered(strategy, step, &errors) || covered_by_planes(strategy, step, &errors))
		return QUERY_CLEAR;
	if (!WITH_BUDGET && !is_measuring_first(strategy)) {
		/* This build has no budgets, so a distance does not help. */
	} else if (strategy->steps_to_next_query > 0 && !is_measuring_first(strategy)) {
		strategy->steps_to_next_query--;
	} else {
		long before = sweep->visits;

		renew(strategy, sweep, step, &errors);
		plane_account_add_query(&strategy->planes, sweep->visits - before);
		if (covered(strategy, step, &errors))
			return QUERY_CLEAR;
	}
	if (halves_by_planes(strategy, step, &errors))
		return QUERY_CLEAR;
	answer = is_target_missed(strategy, sweep, step, contact) ? QUERY_CONTACT
								   : sweep_step(strategy, sweep, step, contact);
	strategy->distance_pays = false;
	return answer;
}

/*
 * The effort for the sweep is used up. Can budgets or planes prove the step, at any cost? Earlier attempts do not
 * count: they depend on the steps before, and thus on what a report has measured.
 */
static bool proved_at_any_price(struct strategy *strategy, struct sweep *sweep, const struct motion_step *step)
{
	struct pair_proof *proof = &strategy->proof;
	const struct position_errors errors = step_errors(proof->bodies.chain, step);

	if (WITH_BUDGET) {
		renew(strategy, sweep, step, &errors);
		if (covered(strategy, step, &errors))
			return true;
	}
	if (!uses_planes(strategy) || !(pair_proof_step_by_planes(proof, step, &errors, true) ||
					pair_proof_halves_by_planes(proof, step, &errors, HALVINGS)))
		return false;
	strategy->plane_steps++;
	return true;
}

enum query_answer strategy_advance_step(struct strategy *strategy, struct sweep *sweep, const struct motion_step *step,
					struct contact *contact)
{
	struct pair_proof *proof = &strategy->proof;
	enum query_answer answer;

	while ((answer = attempt(strategy, sweep, step, contact)) != QUERY_CLEAR && proof->target > proof->clearance) {
		/* This answer is about the target, not the clearance: try a smaller target. */
		double closest = answer == QUERY_CONTACT ? fmin(contact->distance, proof->target) : proof->clearance;

		pair_proof_aim(proof, proof->clearance + strategy->measure_share * (closest - proof->clearance));
	}
	if (answer == QUERY_UNDECIDED && !sweep->broken_off && proved_at_any_price(strategy, sweep, step))
		return QUERY_CLEAR;
	return answer;
}

/* Is every point so close to its chord that the chord errors do not require halving the chord? */
static bool is_nearly_straight(const struct strategy *strategy, const struct chord *chord)
{
	const struct body_pair *bodies = &strategy->proof.bodies;
	struct chain_state start, end;
	struct chord_bound bound;

	chain_state_init(&start, bodies->chain, &chord->q0, &bodies->ball_a, &bodies->ball_b);
	chain_state_init(&end, bodies->chain, &chord->q1, &bodies->ball_a, &bodies->ball_b);
	chord_bound_init(&bound, &(struct joint_chord){
		.chain = bodies->chain, .start = &start, .end = &end,
		.q0 = &chord->q0, .q1 = &chord->q1, .chord_error = &chord->chord_error,
	});
	return fmin(bound.chord_error[0] + bound.displacement[0], bound.chord_error[1] + bound.displacement[1]) <=
	       CHORD_ERROR_SHARE * strategy->proof.coherence.near;
}

/*
 * The number of steps to merge: at most twice the last number. Less than two: merge none. *chord: the chord of these
 * steps.
 */
static size_t choose_merge(const struct strategy *strategy, const struct batch_step *steps, size_t count,
			   struct chord *chord)
{
	size_t merge_count =
	    strategy->merge_count < MERGED_STEPS_MAX / 2 ? 2 * strategy->merge_count : MERGED_STEPS_MAX;
	size_t known = 0;

	merge_count = merge_count < 2 ? 2 : merge_count;
	for (; known < count && known < merge_count && merged_steps_takes(&steps[known]); known++)
		;
	for (; merge_count >= 2; merge_count /= 2) {
		if (merge_count > known)
			continue;
		*chord = merged_steps_chord(steps, merge_count);
		if (is_nearly_straight(strategy, chord))
			break;
	}
	return merge_count;
}

size_t strategy_advance_chord(struct strategy *strategy, struct sweep *sweep, const struct batch_step *steps,
			      size_t count)
{
	struct pair_proof *proof = &strategy->proof;
	struct position_errors errors;
	struct chord chord;
	size_t merge_count;
	bool proved;
	long before;

	if (!WITH_MERGED_STEPS || strategy->distance_pays || strategy->steps_to_next_query <= 0 ||
	    is_measuring_first(strategy))
		return 0;
	if (pair_proof_recall(proof, &steps[0].motion))
		return 0;
	errors = step_errors(proof->bodies.chain, &steps[0].motion);
	if (covered_by_planes(strategy, &steps[0].motion, &errors) ||
	    halves_by_planes(strategy, &steps[0].motion, &errors))
		return 1;
	merge_count = choose_merge(strategy, steps, count, &chord);
	strategy->merge_count = merge_count;
	if (merge_count < 2)
		return 0;
	before = sweep->visits;
	proved = pair_proof_chord(proof, sweep, &chord);
	strategy->sweep_visits += sweep->visits - before;
	plane_account_add_query(&strategy->planes, sweep->visits - before);
	if (!proved) {
		strategy->distance_pays = true;
		return 0;
	}
	strategy->steps_to_next_query -= (int)merge_count;
	return merge_count;
}

/* Like covered_by_planes, for a box of steps. */
static bool box_by_planes(struct strategy *strategy, const axis_values *low, const axis_values *high,
			  const struct position_errors *errors, bool thorough)
{
	struct pair_proof *proof = &strategy->proof;
	long before = proof->planes.visits;
	bool held;

	if (!uses_planes(strategy))
		return false;
	held = pair_proof_box_by_planes(proof, low, high, errors, false);
	if (!held && thorough && plane_account_allows_chunk(&strategy->planes)) {
		held = pair_proof_box_by_planes(proof, low, high, errors, true);
		plane_account_add_search(&strategy->planes, proof->planes.visits - before);
		plane_account_add_chunk(&strategy->planes, held);
	}
	return held;
}

bool strategy_advance_box(struct strategy *strategy, const axis_values *low, const axis_values *high,
			  const struct position_errors *errors, const axis_values *end, size_t steps, bool thorough)
{
	if (pair_proof_box(&strategy->proof, low, high, errors, end, thorough)) {
		strategy->distance_pays = true;
		strategy->covered_steps += (long)steps;
		return true;
	}
	if (!box_by_planes(strategy, low, high, errors, thorough))
		return false;
	plane_account_add_saved(&strategy->planes, steps);
	strategy->plane_steps += (long)steps;
	return true;
}
