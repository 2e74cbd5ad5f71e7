#include "check/certified/strategy.h"

#include <math.h>

#include "base/ablation.h"
#include "check/certified/merged_steps.h"
#include "check/step.h"

/*
 * The share of a distance that a budget is content with. Measured: 0.1 to 0.25
 * are about equally good, 0.7 takes twice as long in all for a fifth fewer queries.
 */
#define BUDGET_SHARE 0.15

/*
 * And of one that is to last longer, asked for where the first is of no use but the distance is there.
 * It may cost as much as the sweeps since the last such query. Measured: 0.35 to 0.5 are about equally good.
 */
#define SHARP_SHARE 0.5
#define SHARP_NEED 2	/* ways of the step that must be there */

/* Ways of the step that a query must prove to have been worth its time. */
#define PAYING_ROOM 4

/* How much of a distance beyond the clearance that turned out too small is tried next when the smallest is measured. */
#define MEASURE_SHARE 0.8

/* And how sharply: where exactly the target is missed does not matter. */
#define MEASURE_GRAIN 0.1

/* Steps that a strategy at most sweeps before it asks for the distance again. Measured: 64 cost a tenth more nearby. */
#define BACKOFF_MAX 256

/*
 * What share of the distance the second-order term and the deviations of a stretch may take. Measured:
 * 0.05 to 0.1 are about equally good; 1 costs four times as much where bodies turn fast close to each other.
 */
#define STRAY_SHARE 0.1

/* Node pairs looked at for one rapid whose way is not known, before the check gives up with an error. */
#define BOX_VISITS 50000000L

void strategy_init(struct strategy *strategy, const struct body_pair *bodies, double clearance, double tolerance,
		   bool measure)
{
	*strategy = (struct strategy){.bodies = *bodies, .clearance = clearance, .tolerance = tolerance};
	strategy->measures = measure;
	strategy->target = measure ? INFINITY : clearance;
	strategy->bodies.coherence = &strategy->coherence;
	kept_budgets_init(&strategy->budgets, bodies->chain);
}

void strategy_cap(struct strategy *strategy, double most)
{
	strategy->target = most;
}

/* What it remembers is its own. */
static void copy_state(struct strategy *to, const struct strategy *from)
{
	*to = *from;
	to->bodies.coherence = &to->coherence;
}

void strategy_fork(const struct strategy *whole, struct strategy *part)
{
	copy_state(part, whole);
	part->covered_steps = part->queries = 0;
	strategy_forget_position(part);
}

void strategy_join(struct strategy *whole, const struct strategy *part)
{
	long covered_steps = whole->covered_steps + part->covered_steps, queries = whole->queries + part->queries;
	double target = fmin(whole->target, part->target);

	copy_state(whole, part);
	whole->covered_steps = covered_steps;
	whole->queries = queries;
	whole->target = target;
}

double strategy_proven(const struct strategy *strategy)
{
	return strategy->target;
}

void strategy_forget_position(struct strategy *strategy)
{
	strategy->position_unknown = true;
	strategy->clear_at_end = false;
}

/*
 * mm: the distance that a quick way must leave to pass a step. No sweep at the target reports what is farther apart than
 * that, and the clearance is never above the target: so no verdict depends on which quick way was tried.
 */
static double needed(const struct strategy *strategy)
{
	return strategy->target + strategy->tolerance;
}

static bool covered(struct strategy *strategy, const struct motion_step *step, const struct position_errors *errors)
{
	const struct span *span = &step->span;
	axis_values low, high;
	bool good;

	if (step_is_box(step)) {
		step_box(step, &low, &high);
		good = kept_budgets_cover_box(&strategy->budgets, &low, &high, &span->q1, errors);
	} else {
		good = kept_budgets_cover(&strategy->budgets, &span->q0, &span->q1, errors);
	}
	if (good) {
		strategy->covered_steps++;
		strategy->clear_at_end = true;
		strategy->sweeps = false;
	}
	return good;
}

/* mm that the step moves the pair, roughly: below that a distance does not help. */
static double way_of(const struct strategy *strategy, const struct chain_state *state, const struct span *span)
{
	const struct chain *chain = strategy->bodies.chain;
	double way = 0;

	for (size_t i = 0; i < chain->count; i++) {
		double dq = fabs(span->q1.v[chain->joints[i].slot] - span->q0.v[chain->joints[i].slot]);

		way += chain->joints[i].rotary ? dq * fmin(state->rho[0][i], state->rho[1][i]) : dq;
	}
	return way;
}

/*
 * mm, a lower bound on the distance at q: coarsely first, and once more sharply where there is enough
 * of it but too little was proved.
 */
static double ask_distance(struct strategy *strategy, struct sweep *sweep, const axis_values *q, double way)
{
	double enough = needed(strategy) + way;
	double distance = sweep_distance(sweep, &strategy->bodies, q, BUDGET_SHARE, enough, 0);

	strategy->queries++;
	if (!WITH_KEPT_BUDGETS || strategy->sweep_visits <= 0 || distance - needed(strategy) > PAYING_ROOM * way ||
	    !(strategy->coherence.near - needed(strategy) > SHARP_NEED * way))
		return distance;
	distance = fmax(distance,
			sweep_distance(sweep, &strategy->bodies, q, SHARP_SHARE, enough, strategy->sweep_visits));
	strategy->queries++;
	strategy->sweep_visits = 0;
	return distance;
}

/* As sharply as the smallest clearance is measured. */
static double measure_distance(struct strategy *strategy, struct sweep *sweep, const axis_values *q, double way)
{
	bool first = isinf(strategy->target);
	double distance = sweep_distance(sweep, &strategy->bodies, q, MEASURE_SHARE,
					 first ? strategy->clearance : needed(strategy) + way, 0);

	strategy->queries++;
	if (first)
		strategy->target = fmax(strategy->clearance, MEASURE_SHARE * distance);
	return distance;
}

/* Asks for the distance where the step ends and starts a new budget with it. */
static void renew(struct strategy *strategy, struct sweep *sweep, const struct motion_step *step)
{
	const struct body_pair *bodies = &strategy->bodies;
	const struct span *span = &step->span;
	struct chain_state state;
	double way, distance, room;

	chain_state_init(&state, bodies->chain, &span->q1, &bodies->ball_a, &bodies->ball_b);
	way = way_of(strategy, &state, span);
	distance = strategy->measures ? measure_distance(strategy, sweep, &span->q1, way)
				      : ask_distance(strategy, sweep, &span->q1, way);
	room = distance - needed(strategy);
	kept_budgets_set(&strategy->budgets, &span->q1, &state, room);
	kept_budgets_resume(&strategy->budgets, &span->q0);
	if (room > PAYING_ROOM * way) {
		strategy->backoff = 1;
	} else {
		strategy->steps_to_next_query = strategy->backoff;
		strategy->backoff = strategy->backoff < BACKOFF_MAX ? 2 * strategy->backoff + 1 : BACKOFF_MAX;
	}
}

/* The question that is open: does the target hold? Above the clearance any contact answers it, and roughly will do. */
static struct clearance_query question(const struct strategy *strategy, struct sweep *sweep)
{
	bool any = strategy->target > strategy->clearance;

	return (struct clearance_query){
		.sweep = sweep,
		.bodies = &strategy->bodies,
		.clearance = strategy->target,
		.tolerance = any ? fmax(strategy->tolerance, MEASURE_GRAIN * (strategy->target - strategy->clearance))
				 : strategy->tolerance,
		.any = any,
		.box_visits = BOX_VISITS,
	};
}

/* The step with the target as it stands. */
static enum query_answer attempt(struct strategy *strategy, struct sweep *sweep, const struct motion_step *step,
			    struct contact *contact)
{
	const struct chain *chain = strategy->bodies.chain;
	enum sweep_answer answer;
	const struct position_errors errors = step_errors(chain, step);
	struct clearance_query query;

	if (strategy->clear_at_end && !step_moves(chain, step) && !step_may_stray(chain, step))
		return QUERY_CLEAR;
	if (covered(strategy, step, &errors))
		return QUERY_CLEAR;
	if (!WITH_BUDGET && !isinf(strategy->target)) {
		/* No distance is of use. */
	} else if (strategy->steps_to_next_query > 0 && !isinf(strategy->target)) {
		strategy->steps_to_next_query--;
	} else {
		renew(strategy, sweep, step);
		if (covered(strategy, step, &errors))
			return QUERY_CLEAR;
	}
	query = question(strategy, sweep);
	strategy->sweep_visits -= sweep->visits;
	answer = step_sweep(&query, step, contact);
	strategy->sweep_visits += sweep->visits;
	strategy->sweeps = true;
	kept_budgets_resume(&strategy->budgets, &step->span.q1);
	strategy->clear_at_end = answer == SWEEP_APART;
	return answer == SWEEP_APART ? QUERY_CLEAR : answer == SWEEP_CONTACT ? QUERY_CONTACT : QUERY_UNDECIDED;
}

enum query_answer strategy_advance_step(struct strategy *strategy, struct sweep *sweep, const struct motion_step *step,
			   struct contact *contact)
{
	enum query_answer answer;

	if (strategy->position_unknown)
		kept_budgets_resume(&strategy->budgets, &step->span.q0);
	strategy->position_unknown = false;
	while ((answer = attempt(strategy, sweep, step, contact)) != QUERY_CLEAR &&
	       strategy->target > strategy->clearance) {
		double less = 0;

		/* Neither a finding nor undecided yet: less than was hoped for may remain. */
		if (answer == QUERY_CONTACT)
			less = strategy->clearance +
			       MEASURE_SHARE * (fmin(contact->distance, strategy->target) - strategy->clearance);
		strategy->target = less > strategy->clearance + strategy->tolerance ? less : strategy->clearance;
		kept_budgets_resume(&strategy->budgets, &step->span.q0);
	}
	return answer;
}

/* The most that the control may leave any of the steps by; NULL: it may not. */
static const axis_values *play_of_steps(const struct chain *chain, const struct batch_step *steps, size_t count,
					axis_values *play)
{
	bool any = false;

	*play = steps[0].motion.tolerance;
	for (size_t i = 0; i < count; i++) {
		for (int k = 0; k < SLOT_COUNT; k++)
			play->v[k] = fmax(play->v[k], steps[i].motion.tolerance.v[k]);
		any |= step_may_stray(chain, &steps[i].motion);
	}
	return any ? play : NULL;
}

/* Is the chord so nearly straight for every point that it need not be halved for that? */
static bool is_taut(const struct strategy *strategy, const struct chord *chord)
{
	const struct body_pair *bodies = &strategy->bodies;
	struct chain_state start, end;
	struct chord_bound bound;

	chain_state_init(&start, bodies->chain, &chord->q0, &bodies->ball_a, &bodies->ball_b);
	chain_state_init(&end, bodies->chain, &chord->q1, &bodies->ball_a, &bodies->ball_b);
	chord_bound_init(&bound, bodies->chain, &start, &end, &chord->q0, &chord->q1, &chord->deviation, NULL);
	return fmin(bound.bend[0] + bound.drift[0], bound.bend[1] + bound.drift[1]) <=
	       STRAY_SHARE * strategy->coherence.near;
}

/* The longest stretch that is worth it, not much longer than the last; less than two steps: none. */
static size_t choose_merge(const struct strategy *strategy, const struct batch_step *steps, size_t count,
			     struct chord *chord)
{
	size_t merge_count = strategy->merge_count < MERGED_STEPS_MAX / 2 ? 2 * strategy->merge_count : MERGED_STEPS_MAX, known = 0;

	merge_count = merge_count < 2 ? 2 : merge_count;
	for (; known < count && known < merge_count && merged_steps_takes(&steps[known]); known++)
		;
	for (; merge_count >= 2; merge_count /= 2) {
		if (merge_count > known)
			continue;
		*chord = merged_steps_chord(steps, merge_count);
		if (is_taut(strategy, chord))
			break;
	}
	return merge_count;
}

size_t strategy_advance_chord(struct strategy *strategy, struct sweep *sweep, const struct batch_step *steps, size_t count)
{
	struct contact contact;
	enum sweep_answer answer;
	struct clearance_query query;
	struct chord chord;
	axis_values play;
	const struct position_errors errors = step_errors(strategy->bodies.chain, &steps[0].motion);
	size_t merge_count;

	if (!WITH_MERGED_STEPS || !strategy->sweeps || strategy->steps_to_next_query <= 0 || isinf(strategy->target))
		return 0;
	if (kept_budgets_recall(&strategy->budgets, &steps[0].motion.span.q0, &steps[0].motion.span.q1, &errors))
		return 0;
	merge_count = choose_merge(strategy, steps, count, &chord);
	strategy->merge_count = merge_count;
	if (merge_count < 2)
		return 0;
	query = question(strategy, sweep);
	query.clearance = needed(strategy);
	query.any = true;
	chord.tolerance = play_of_steps(strategy->bodies.chain, steps, merge_count, &play);
	strategy->sweep_visits -= sweep->visits;
	answer = chord_sweep(&query, &chord, &contact);
	strategy->sweep_visits += sweep->visits;
	if (answer != SWEEP_APART) {
		strategy->sweeps = false;
		return 0;
	}
	strategy->steps_to_next_query -= (int)merge_count;
	strategy->clear_at_end = true;
	strategy->position_unknown = false;
	kept_budgets_resume(&strategy->budgets, &chord.q1);
	return merge_count;
}

bool strategy_advance_box(struct strategy *strategy, const axis_values *low, const axis_values *high,
		   const struct position_errors *errors, const axis_values *end, size_t steps)
{
	if (!kept_budgets_cover_box(&strategy->budgets, low, high, end, errors))
		return false;
	strategy->covered_steps += (long)steps;
	strategy->clear_at_end = true;
	strategy->position_unknown = false;
	strategy->sweeps = false;
	return true;
}
