#include "check/certified.h"

#include <math.h>

#include "base/ablation.h"
#include "check/step.h"
#include "check/stretch.h"

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

/* Steps that a follower at most sweeps before it asks for the distance again. Measured: 64 cost a tenth more nearby. */
#define PATIENCE_MAX 256

/*
 * What share of the distance the second-order term and the deviations of a stretch may take. Measured:
 * 0.05 to 0.1 are about equally good; 1 costs four times as much where bodies turn fast close to each other.
 */
#define STRAY_SHARE 0.1

/* Node pairs looked at for one rapid whose way is not known, before the check gives up with an error. */
#define BOX_VISITS 50000000L

void follower_init(struct follower *follower, const struct body_pair *bodies, double clearance, double tolerance,
		   bool measure)
{
	*follower = (struct follower){.bodies = *bodies, .clearance = clearance, .tolerance = tolerance};
	follower->measures = measure;
	follower->target = measure ? INFINITY : clearance;
	follower->bodies.coherence = &follower->coherence;
	budgets_init(&follower->budgets, bodies->chain);
}

void follower_cap(struct follower *follower, double most)
{
	follower->target = most;
}

/* What it remembers is its own. */
static void copy_state(struct follower *to, const struct follower *from)
{
	*to = *from;
	to->bodies.coherence = &to->coherence;
}

void follower_fork(const struct follower *whole, struct follower *part)
{
	copy_state(part, whole);
	part->covered_steps = part->queries = 0;
	follower_lose(part);
}

void follower_join(struct follower *whole, const struct follower *part)
{
	long covered_steps = whole->covered_steps + part->covered_steps, queries = whole->queries + part->queries;
	double target = fmin(whole->target, part->target);

	copy_state(whole, part);
	whole->covered_steps = covered_steps;
	whole->queries = queries;
	whole->target = target;
}

double follower_proven(const struct follower *follower)
{
	return follower->target;
}

void follower_lose(struct follower *follower)
{
	follower->lost = true;
	follower->settled = false;
}

/*
 * mm: the distance that a quick way must leave to pass a step. No sweep at the target reports what is farther apart than
 * that, and the clearance is never above the target: so no verdict depends on which quick way was tried.
 */
static double needed(const struct follower *follower)
{
	return follower->target + follower->tolerance;
}

static bool covered(struct follower *follower, const struct motion_step *step, const struct position_errors *errors)
{
	const struct span *span = &step->span;
	axis_values low, high;
	bool good;

	if (step_is_box(step)) {
		step_box(step, &low, &high);
		good = budgets_cover_box(&follower->budgets, &low, &high, &span->q1, errors);
	} else {
		good = budgets_cover(&follower->budgets, &span->q0, &span->q1, errors);
	}
	if (good) {
		follower->covered_steps++;
		follower->settled = true;
		follower->sweeps = false;
	}
	return good;
}

/* mm that the step moves the pair, roughly: below that a distance does not help. */
static double way_of(const struct follower *follower, const struct chain_state *state, const struct span *span)
{
	const struct chain *chain = follower->bodies.chain;
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
static double ask_distance(struct follower *follower, struct sweep *sweep, const axis_values *q, double way)
{
	double enough = needed(follower) + way;
	double distance = sweep_distance(sweep, &follower->bodies, q, BUDGET_SHARE, enough, 0);

	follower->queries++;
	if (!WITH_KEPT_BUDGETS || follower->sweep_visits <= 0 || distance - needed(follower) > PAYING_ROOM * way ||
	    !(follower->coherence.near - needed(follower) > SHARP_NEED * way))
		return distance;
	distance = fmax(distance,
			sweep_distance(sweep, &follower->bodies, q, SHARP_SHARE, enough, follower->sweep_visits));
	follower->queries++;
	follower->sweep_visits = 0;
	return distance;
}

/* As sharply as the smallest clearance is measured. */
static double measure_distance(struct follower *follower, struct sweep *sweep, const axis_values *q, double way)
{
	bool first = isinf(follower->target);
	double distance = sweep_distance(sweep, &follower->bodies, q, MEASURE_SHARE,
					 first ? follower->clearance : needed(follower) + way, 0);

	follower->queries++;
	if (first)
		follower->target = fmax(follower->clearance, MEASURE_SHARE * distance);
	return distance;
}

/* Asks for the distance where the step ends and starts a new budget with it. */
static void renew(struct follower *follower, struct sweep *sweep, const struct motion_step *step)
{
	const struct body_pair *bodies = &follower->bodies;
	const struct span *span = &step->span;
	struct chain_state state;
	double way, distance, room;

	chain_state_init(&state, bodies->chain, &span->q1, &bodies->ball_a, &bodies->ball_b);
	way = way_of(follower, &state, span);
	distance = follower->measures ? measure_distance(follower, sweep, &span->q1, way)
				      : ask_distance(follower, sweep, &span->q1, way);
	room = distance - needed(follower);
	budgets_set(&follower->budgets, &span->q1, &state, room);
	budgets_resume(&follower->budgets, &span->q0);
	if (room > PAYING_ROOM * way) {
		follower->patience = 1;
	} else {
		follower->wait = follower->patience;
		follower->patience = follower->patience < PATIENCE_MAX ? 2 * follower->patience + 1 : PATIENCE_MAX;
	}
}

/* The question that is open: does the target hold? Above the clearance any contact answers it, and roughly will do. */
static struct passing question(const struct follower *follower, struct sweep *sweep)
{
	bool any = follower->target > follower->clearance;

	return (struct passing){
		.sweep = sweep,
		.bodies = &follower->bodies,
		.clearance = follower->target,
		.tolerance = any ? fmax(follower->tolerance, MEASURE_GRAIN * (follower->target - follower->clearance))
				 : follower->tolerance,
		.any = any,
		.box_visits = BOX_VISITS,
	};
}

/* The step with the target as it stands. */
static enum passage attempt(struct follower *follower, struct sweep *sweep, const struct motion_step *step,
			    struct contact *contact)
{
	const struct chain *chain = follower->bodies.chain;
	enum sweep_answer answer;
	const struct position_errors errors = step_errors(chain, step);
	struct passing passing;

	if (follower->settled && !step_moves(chain, step) && !step_may_stray(chain, step))
		return PASSAGE_CLEAR;
	if (covered(follower, step, &errors))
		return PASSAGE_CLEAR;
	if (!WITH_BUDGET && !isinf(follower->target)) {
		/* No distance is of use. */
	} else if (follower->wait > 0 && !isinf(follower->target)) {
		follower->wait--;
	} else {
		renew(follower, sweep, step);
		if (covered(follower, step, &errors))
			return PASSAGE_CLEAR;
	}
	passing = question(follower, sweep);
	follower->sweep_visits -= sweep->visits;
	answer = step_sweep(&passing, step, contact);
	follower->sweep_visits += sweep->visits;
	follower->sweeps = true;
	budgets_resume(&follower->budgets, &step->span.q1);
	follower->settled = answer == SWEEP_APART;
	return answer == SWEEP_APART ? PASSAGE_CLEAR : answer == SWEEP_CONTACT ? PASSAGE_CONTACT : PASSAGE_UNDECIDED;
}

enum passage follower_step(struct follower *follower, struct sweep *sweep, const struct motion_step *step,
			   struct contact *contact)
{
	enum passage passage;

	if (follower->lost)
		budgets_resume(&follower->budgets, &step->span.q0);
	follower->lost = false;
	while ((passage = attempt(follower, sweep, step, contact)) != PASSAGE_CLEAR &&
	       follower->target > follower->clearance) {
		double less = 0;

		/* Neither a finding nor undecided yet: less than was hoped for may remain. */
		if (passage == PASSAGE_CONTACT)
			less = follower->clearance +
			       MEASURE_SHARE * (fmin(contact->distance, follower->target) - follower->clearance);
		follower->target = less > follower->clearance + follower->tolerance ? less : follower->clearance;
		budgets_resume(&follower->budgets, &step->span.q0);
	}
	return passage;
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
static bool is_taut(const struct follower *follower, const struct chord *chord)
{
	const struct body_pair *bodies = &follower->bodies;
	struct chain_state start, end;
	struct chord_bound bound;

	chain_state_init(&start, bodies->chain, &chord->q0, &bodies->ball_a, &bodies->ball_b);
	chain_state_init(&end, bodies->chain, &chord->q1, &bodies->ball_a, &bodies->ball_b);
	chord_bound_init(&bound, bodies->chain, &start, &end, &chord->q0, &chord->q1, &chord->deviation, NULL);
	return fmin(bound.bend[0] + bound.drift[0], bound.bend[1] + bound.drift[1]) <=
	       STRAY_SHARE * follower->coherence.near;
}

/* The longest stretch that is worth it, not much longer than the last; less than two steps: none. */
static size_t choose_stretch(const struct follower *follower, const struct batch_step *steps, size_t count,
			     struct chord *chord)
{
	size_t stride = follower->stride < STRETCH_MAX / 2 ? 2 * follower->stride : STRETCH_MAX, known = 0;

	stride = stride < 2 ? 2 : stride;
	for (; known < count && known < stride && stretch_takes(&steps[known]); known++)
		;
	for (; stride >= 2; stride /= 2) {
		if (stride > known)
			continue;
		*chord = stretch_chord(steps, stride);
		if (is_taut(follower, chord))
			break;
	}
	return stride;
}

size_t follower_leap(struct follower *follower, struct sweep *sweep, const struct batch_step *steps, size_t count)
{
	struct contact contact;
	enum sweep_answer answer;
	struct passing passing;
	struct chord chord;
	axis_values play;
	const struct position_errors errors = step_errors(follower->bodies.chain, &steps[0].motion);
	size_t stride;

	if (!WITH_STRETCHES || !follower->sweeps || follower->wait <= 0 || isinf(follower->target))
		return 0;
	if (budgets_recall(&follower->budgets, &steps[0].motion.span.q0, &steps[0].motion.span.q1, &errors))
		return 0;
	stride = choose_stretch(follower, steps, count, &chord);
	follower->stride = stride;
	if (stride < 2)
		return 0;
	passing = question(follower, sweep);
	passing.clearance = needed(follower);
	passing.any = true;
	chord.tolerance = play_of_steps(follower->bodies.chain, steps, stride, &play);
	follower->sweep_visits -= sweep->visits;
	answer = chord_sweep(&passing, &chord, &contact);
	follower->sweep_visits += sweep->visits;
	if (answer != SWEEP_APART) {
		follower->sweeps = false;
		return 0;
	}
	follower->wait -= (int)stride;
	follower->settled = true;
	follower->lost = false;
	budgets_resume(&follower->budgets, &chord.q1);
	return stride;
}

bool follower_skip(struct follower *follower, const axis_values *low, const axis_values *high,
		   const struct position_errors *errors, const axis_values *end, size_t steps)
{
	if (!budgets_cover_box(&follower->budgets, low, high, end, errors))
		return false;
	follower->covered_steps += (long)steps;
	follower->settled = true;
	follower->lost = false;
	follower->sweeps = false;
	return true;
}
