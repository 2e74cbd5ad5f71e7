#include "check/step.h"

#include <math.h>

#include "motion/path.h"

bool step_moves(const struct chain *chain, const struct motion_step *step)
{
	const struct span *span = &step->span;

	for (size_t i = 0; i < chain->count; i++) {
		int slot = chain->joints[i].slot;

		if (span->q1.v[slot] < span->q0.v[slot] || span->q1.v[slot] > span->q0.v[slot] ||
		    span->chord_error.v[slot] > 0)
			return true;
	}
	return false;
}

bool step_may_leave_path(const struct chain *chain, const struct motion_step *step)
{
	for (size_t i = 0; i < chain->count; i++)
		if (step->tolerance.v[chain->joints[i].slot] > 0)
			return true;
	return false;
}

static bool may_be_off(const struct chain *chain, const struct motion_step *step)
{
	for (size_t i = 0; i < chain->count; i++) {
		const int slot = chain->joints[i].slot;

		if (step->span.chord_error.v[slot] > 0 || step->tolerance.v[slot] > 0)
			return true;
	}
	return false;
}

struct position_errors step_errors(const struct chain *chain, const struct motion_step *step)
{
	struct position_errors errors = {.any = may_be_off(chain, step)};

	for (size_t i = 0; i < chain->count && errors.any; i++) {
		int slot = chain->joints[i].slot;

		errors.chord.v[slot] = step->span.chord_error.v[slot];
		errors.path.v[slot] = step->tolerance.v[slot];
	}
	return errors;
}

bool step_is_box(const struct motion_step *step)
{
	return step->span.path->kind == PATH_BOX;
}

void step_box(const struct motion_step *step, axis_values *low, axis_values *high)
{
	for (int i = 0; i < SLOT_COUNT; i++) {
		low->v[i] = fmin(step->span.q0.v[i], step->span.q1.v[i]);
		high->v[i] = fmax(step->span.q0.v[i], step->span.q1.v[i]);
	}
}
