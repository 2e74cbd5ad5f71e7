#include "check/gauge.h"

#include <math.h>

#include "check/step.h"

/* What share of a distance a look is content with: more costs far more than asking whether a distance holds. */
#define LOOK_SHARE 0.2

/* What share of the smallest distance that was seen is enough; how sharply it is asked for, as a share of that. */
#define ENOUGH 0.9
#define GRAIN 0.03

/* Questions to a step before each is for half as much: by then the search has long come to an end. */
#define PATIENCE 60

/* Node pairs looked at for one rapid whose way is not known, before less is asked for. */
#define BOX_VISITS 1000000L

void gauge_init(struct gauge *gauge, const struct body_pair *bodies, double cap)
{
	*gauge = (struct gauge){.bodies = *bodies, .cap = cap, .bound = cap};
	gauge->bodies.coherence = &gauge->coherence;
	budget_init(&gauge->budget, bodies->chain);
}

void gauge_start(struct gauge *gauge)
{
	gauge->bound = gauge->cap;
}

bool gauge_clears(const struct gauge *gauge, const axis_values *low, const axis_values *high,
		  const struct position_errors *errors)
{
	return !gauge->entangled && budget_rest(&gauge->budget, low, high, errors) > gauge->cap;
}

/* The distance where the step ends is where the next step can begin with. */
static void renew(struct gauge *gauge, struct sweep *sweep, const axis_values *q)
{
	const struct body_pair *bodies = &gauge->bodies;
	struct chain_state state;
	double proven = sweep_distance(sweep, bodies, q, LOOK_SHARE, 0, 0);

	gauge->found = gauge->coherence.near;
	chain_state_init(&state, bodies->chain, q, &bodies->ball_a, &bodies->ball_b);
	budget_set(&gauge->budget, q, &state, proven);
}

/* Is what is left of a proven distance enough, or nearly all that there can be? Then it is the bound. */
static bool spend(struct gauge *gauge, const axis_values *low, const axis_values *high,
		  const struct position_errors *errors, double *rest)
{
	double most;

	*rest = budget_rest(&gauge->budget, low, high, errors);
	most = gauge->found + (gauge->budget.room - *rest);
	if (!(*rest > 0) || (*rest <= gauge->bound && *rest < ENOUGH * most))
		return false;
	gauge->bound = fmin(gauge->bound, *rest);
	return true;
}

/* What to ask for next between what holds (0: nothing yet) and what was seen not to. */
static double next_target(double low, double high, int failures)
{
	if (failures < 2)
		return 0.95 * high;
	return low > 0 ? fmin(sqrt(low * high), 0.95 * high) : 0.5 * high;
}

/*
 * Asks what distance holds throughout the step. Each answer that one does not
 * shows a smaller one; the search ends when what holds is nearly that.
 */
static void prove(struct gauge *gauge, struct sweep *sweep, const struct motion_step *step, double rest,
		  double tolerance)
{
	double low = fmax(rest, 0), high = gauge->found;
	double target = high < gauge->bound ? next_target(low, high, 0) : gauge->bound;
	int failures = 0;

	for (int round = 0; low < fmin(ENOUGH * high, gauge->bound) && target > tolerance; round++) {
		struct passing passing = {sweep, &gauge->bodies, target, fmax(tolerance, GRAIN * target), true, BOX_VISITS};
		struct contact contact;
		enum sweep_answer answer = step_sweep(&passing, step, &contact);

		if (answer == SWEEP_APART) {
			low = target;
		} else if (answer == SWEEP_UNDECIDED || round >= PATIENCE) {
			high = target;
			failures = 2;
		} else {
			high = fmin(contact.distance, target + passing.tolerance);
			failures++;
		}
		target = next_target(low, high, failures);
	}
	gauge->bound = low > tolerance ? fmin(gauge->bound, low) : 0;
}

void gauge_step(struct gauge *gauge, struct sweep *sweep, const struct motion_step *step, double tolerance)
{
	const struct position_errors errors = step_errors(gauge->bodies.chain, step);
	axis_values low, high;
	double rest;

	if (!(gauge->bound > 0))
		return;
	step_box(step, &low, &high);
	if (spend(gauge, &low, &high, &errors, &rest))
		return;
	renew(gauge, sweep, &step->span.q1);
	if (!spend(gauge, &low, &high, &errors, &rest))
		prove(gauge, sweep, step, rest, tolerance);
}
