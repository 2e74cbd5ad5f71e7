#include "check/certified/merged_steps.h"

#include <assert.h>
#include <math.h>

#include "check/step.h"
#include "motion/span.h"

/*
 * mm: the weight of a radian when the speeds along merged steps are chosen. The proof holds for any value; a good one
 * keeps the deviations small.
 */
#define RADIAN 100.0

bool merged_steps_takes(const struct batch_step *step)
{
	return step->motion.span.path->kind != PATH_BOX;
}

static double way_of(const struct span *span)
{
	double way = 0;

	for (int i = 0; i < SLOT_COUNT; i++)
		way += fabs(span->q1.v[i] - span->q0.v[i]) * (slot_is_rotary(i) ? RADIAN : 1);
	return way;
}

/* Widens the deviations to hold the corner q, which the chord passes at s. */
static void hold_corner(struct chord *chord, const axis_values *q, double s)
{
	for (int i = 0; i < SLOT_COUNT; i++) {
		double off = fabs(q->v[i] - ((1 - s) * chord->q0.v[i] + s * chord->q1.v[i]));

		chord->chord_error.v[i] = fmax(chord->chord_error.v[i], off);
	}
}

static void halve(const struct chord *whole, struct chord *first, struct chord *second);

/*
 * The chord of the steps u0 to u1 - 1. Between two corners both the chord and the step are linear, so they are farthest
 * apart at a corner. The deviation is that distance plus the largest deviation of a step from its own line.
 */
static struct chord over_steps(const struct batch_step *steps, double u0, double u1)
{
	size_t first = (size_t)u0, last = (size_t)u1 - 1;
	struct chord chord = {.q0 = steps[first].motion.span.q0, .q1 = steps[last].motion.span.q1,
			      .curve = steps, .u0 = u0, .u1 = u1, .halve = halve};
	double whole = 0, way = 0;
	axis_values own = steps[first].motion.span.chord_error;

	for (size_t i = first; i <= last; i++)
		whole += way_of(&steps[i].motion.span);
	for (size_t i = first; i < last; i++) {
		way += way_of(&steps[i].motion.span);
		hold_corner(&chord, &steps[i].motion.span.q1, whole > 0 ? way / whole : 0);
		for (int k = 0; k < SLOT_COUNT; k++)
			own.v[k] = fmax(own.v[k], steps[i + 1].motion.span.chord_error.v[k]);
	}
	for (int k = 0; k < SLOT_COUNT; k++)
		chord.chord_error.v[k] += own.v[k];
	return chord;
}

/* A piece of one step. */
static void halve_step(const struct chord *whole, struct chord *first, struct chord *second)
{
	const struct batch_step *steps = whole->curve;
	double begin = floor(whole->u0);
	const struct span *step = &steps[(size_t)begin].motion.span;
	double length = step->u1 - step->u0;
	const struct span span = {whole->q0, whole->q1, whole->chord_error, step->path,
				  step->u0 + (whole->u0 - begin) * length, step->u0 + (whole->u1 - begin) * length};
	double middle = 0.5 * (whole->u0 + whole->u1);
	struct span halves[2];

	span_halve(&span, &halves[0], &halves[1]);
	*first = (struct chord){halves[0].q0, halves[0].q1, halves[0].chord_error, whole->tolerance, steps, whole->u0,
				middle, halve};
	*second = (struct chord){halves[1].q0, halves[1].q1, halves[1].chord_error, whole->tolerance, steps, middle,
				 whole->u1, halve};
}

static void halve(const struct chord *whole, struct chord *first, struct chord *second)
{
	double middle = 0.5 * (whole->u0 + whole->u1);
	const struct batch_step *steps = whole->curve;

	if (whole->u1 - whole->u0 <= 1) {
		halve_step(whole, first, second);
		return;
	}
	*first = over_steps(steps, whole->u0, middle);
	*second = over_steps(steps, middle, whole->u1);
	first->tolerance = second->tolerance = whole->tolerance;
}

struct chord merged_steps_chord(const struct batch_step *steps, size_t count)
{
	assert(count > 0 && count <= MERGED_STEPS_MAX && !(count & (count - 1)));
	return over_steps(steps, 0, (double)count);
}

const axis_values *merged_steps_tolerance(const struct chain *chain, const struct chord *merged, axis_values *most)
{
	const struct batch_step *steps = merged->curve;
	size_t count = (size_t)merged->u1;
	bool any = false;

	*most = steps[0].motion.tolerance;
	for (size_t i = 0; i < count; i++) {
		for (int k = 0; k < SLOT_COUNT; k++)
			most->v[k] = fmax(most->v[k], steps[i].motion.tolerance.v[k]);
		any |= step_may_leave_path(chain, &steps[i].motion);
	}
	return any ? most : NULL;
}
