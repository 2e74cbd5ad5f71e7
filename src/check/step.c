#include "check/step.h"

#include <math.h>

#include "motion/path.h"
#include "motion/span.h"

bool step_moves(const struct chain *chain, const struct motion_step *step)
{
	const struct span *span = &step->span;

	for (size_t i = 0; i < chain->count; i++) {
		int slot = chain->joints[i].slot;

		if (span->q1.v[slot] < span->q0.v[slot] || span->q1.v[slot] > span->q0.v[slot] ||
		    span->deviation.v[slot] > 0)
			return true;
	}
	return false;
}

bool step_may_stray(const struct chain *chain, const struct motion_step *step)
{
	for (size_t i = 0; i < chain->count; i++)
		if (step->tolerance.v[chain->joints[i].slot] > 0)
			return true;
	return false;
}

struct position_errors step_errors(const struct chain *chain, const struct motion_step *step)
{
	struct position_errors errors = {.any = false};

	for (size_t i = 0; i < chain->count; i++) {
		int slot = chain->joints[i].slot;

		errors.chord.v[slot] = step->span.deviation.v[slot];
		errors.path.v[slot] = step->tolerance.v[slot];
		errors.any |= errors.chord.v[slot] > 0 || errors.path.v[slot] > 0;
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

static void halve(const struct chord *whole, struct chord *first, struct chord *second)
{
	const struct span span = {whole->q0, whole->q1, whole->deviation, whole->curve, whole->u0, whole->u1};
	struct span halves[2];
	struct chord *out[2] = {first, second};

	span_halve(&span, &halves[0], &halves[1]);
	for (int i = 0; i < 2; i++)
		*out[i] = (struct chord){halves[i].q0, halves[i].q1, halves[i].deviation, whole->tolerance,
					 whole->curve, halves[i].u0, halves[i].u1, whole->halve};
}

enum sweep_answer chord_sweep(const struct clearance_query *query, const struct chord *chord, struct contact *contact)
{
	return (query->any ? sweep_chord_any : sweep_chord)(query->sweep, query->bodies, chord,
							      query->clearance, query->tolerance, contact);
}

static enum sweep_answer sweep_positions(const struct clearance_query *query, const struct motion_step *step,
					 struct contact *contact)
{
	axis_values low, high;

	step_box(step, &low, &high);
	for (int i = 0; i < SLOT_COUNT; i++) {
		low.v[i] -= step->tolerance.v[i];
		high.v[i] += step->tolerance.v[i];
	}
	return sweep_box(query->sweep, query->bodies, &low, &high, query->clearance, query->tolerance,
			 query->box_visits, contact);
}

enum sweep_answer step_sweep(const struct clearance_query *query, const struct motion_step *step, struct contact *contact)
{
	const struct span *span = &step->span;
	bool strays = step_may_stray(query->bodies->chain, step);
	const struct chord chord = {span->q0, span->q1, span->deviation, strays ? &step->tolerance : NULL,
				    span->path, span->u0, span->u1, halve};

	if (step_is_box(step))
		return sweep_positions(query, step, contact);
	return chord_sweep(query, &chord, contact);
}
