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

bool step_off_the_line(const struct chain *chain, const struct motion_step *step, axis_values *off)
{
	bool any = false;

	*off = (axis_values){{0}};
	for (size_t i = 0; i < chain->count; i++) {
		int slot = chain->joints[i].slot;

		off->v[slot] = step->span.deviation.v[slot] + step->tolerance.v[slot];
		any |= off->v[slot] > 0;
	}
	return any;
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
		*out[i] = (struct chord){halves[i].q0, halves[i].q1, halves[i].deviation, whole->curve,
					 halves[i].u0, halves[i].u1, whole->halve};
}

/* mm: how far the control may carry a point off the programmed path. */
static double freedom(const struct body_pair *bodies, const struct chord *chord, const axis_values *tolerance)
{
	struct chain_state start, end;
	struct chord_bound both, path;

	chain_state_init(&start, bodies->chain, &chord->q0, &bodies->ball_a, &bodies->ball_b);
	chain_state_init(&end, bodies->chain, &chord->q1, &bodies->ball_a, &bodies->ball_b);
	chord_bound_init(&both, bodies->chain, &start, &end, &chord->q0, &chord->q1, &chord->deviation, tolerance);
	chord_bound_init(&path, bodies->chain, &start, &end, &chord->q0, &chord->q1, &chord->deviation, NULL);
	/* The sweep accounts for the path's own deviation, which shrinks as it bisects. */
	return fmax(both.drift[0] - path.drift[0], both.drift[1] - path.drift[1]);
}

enum sweep_answer chord_sweep(const struct passing *passing, const struct chord *chord, const axis_values *play,
			      struct contact *contact)
{
	double clearance = passing->clearance + (play ? freedom(passing->bodies, chord, play) : 0);

	if (passing->any)
		return sweep_chord_any(passing->sweep, passing->bodies, chord, clearance, passing->tolerance, contact);
	return sweep_chord(passing->sweep, passing->bodies, chord, clearance, passing->tolerance, contact);
}

static enum sweep_answer sweep_positions(const struct passing *passing, const struct motion_step *step,
					 struct contact *contact)
{
	axis_values low, high;

	step_box(step, &low, &high);
	for (int i = 0; i < SLOT_COUNT; i++) {
		low.v[i] -= step->tolerance.v[i];
		high.v[i] += step->tolerance.v[i];
	}
	return sweep_box(passing->sweep, passing->bodies, &low, &high, passing->clearance, passing->tolerance,
			 passing->box_visits, contact);
}

enum sweep_answer step_sweep(const struct passing *passing, const struct motion_step *step, struct contact *contact)
{
	const struct span *span = &step->span;
	struct chord chord = {span->q0, span->q1, span->deviation, span->path, span->u0, span->u1, halve};

	if (step_is_box(step))
		return sweep_positions(passing, step, contact);
	return chord_sweep(passing, &chord, step_may_stray(passing->bodies->chain, step) ? &step->tolerance : NULL,
			   contact);
}
