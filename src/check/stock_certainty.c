#include "check/stock_certainty.h"

#include <math.h>

#include "check/step.h"

/* Number of instants examined: in the step of the contact, and in total. */
#define STEP_INSTANTS 12
#define BLOCK_INSTANTS 36

/*
 * The time at which the stock is taken. For a cutter that must not cut, by a rule of the user, this is the start of its
 * step.
 */
static double time_of(const struct stock_pair *check, const struct batch_step *step, double s)
{
	return (double)step->number + (check->feeds_too && step->motion.step_class == STEP_FEED_TURNING ? 0 : s);
}

static bool proves(struct stock_pair *check, const struct batch_step *step, double s)
{
	const struct span *span = &step->motion.span;
	const axis_values q = axis_values_between(&span->q0, &span->q1, s);
	const struct chord chord = {.q0 = span->q0, .q1 = span->q1, .chord_error = span->chord_error,
				    .tolerance = &step->motion.tolerance};

	return stock_sweep_proves(&check->sweep, &chord, &q, time_of(check, step, s));
}

bool stock_certainty_from(struct stock_pair *check, const struct batch *batch, size_t first, double s)
{
	const long block = batch->steps[first].block;
	int left = BLOCK_INSTANTS;

	for (size_t i = first; i < batch->step_count && batch->steps[i].block == block && left > 0; i++) {
		const struct batch_step *step = &batch->steps[i];
		const int count = i == first ? STEP_INSTANTS : 1;

		/* The path of such a step is not known. */
		if (step->motion.bounded || step_is_box(&step->motion))
			return false;
		if (!pair_watch_has(&check->watch, step))
			continue;
		for (int n = 1; n <= count; n++, left--)
			if (proves(check, step, i == first ? s + (1 - s) * n / count : 1))
				return true;
	}
	return false;
}

bool stock_certainty_at(struct stock_pair *check, const axis_values *q, double number)
{
	const struct chord still = {.q0 = *q, .q1 = *q};

	return stock_sweep_proves(&check->sweep, &still, q, number);
}
