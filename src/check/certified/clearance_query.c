#include "check/certified/clearance_query.h"

#include "check/step.h"
#include "motion/path.h"
#include "motion/span.h"

void clearance_query_halve(const struct chord *whole, struct chord *first, struct chord *second)
{
	const struct span span = {whole->q0, whole->q1, whole->chord_error, whole->curve, whole->u0, whole->u1};
	struct span halves[2];
	struct chord *out[2] = {first, second};

	span_halve(&span, &halves[0], &halves[1]);
	for (int i = 0; i < 2; i++)
		*out[i] = (struct chord){halves[i].q0, halves[i].q1, halves[i].chord_error, whole->tolerance,
					 whole->curve, halves[i].u0, halves[i].u1, whole->halve};
}

enum query_answer clearance_query_chord(const struct clearance_query *query, const struct chord *chord,
					struct contact *contact)
{
	return query_answer_of((query->any ? sweep_chord_any : sweep_chord)(query->sweep, query->bodies, chord,
								      query->clearance, query->tolerance, contact));
}

/*
 * As in struct swept_box. Measured on 90 rapids of five axes between the blades of an impeller, whole runs: 0.1 takes
 * 1.6 times as long, 0.2 1.14 times, 0.8 1.06 times. A clear rapid with 0.1 examined 20 times as many node pairs.
 */
#define LOST 0.4

static enum query_answer sweep_positions(const struct clearance_query *query, const struct motion_step *step,
					 struct contact *contact)
{
	axis_values low, high;
	const struct swept_box box = {.low = &low, .high = &high, .lost = LOST, .max_visits = query->box_visits};

	step_box(step, &low, &high);
	for (int i = 0; i < SLOT_COUNT; i++) {
		low.v[i] -= step->tolerance.v[i];
		high.v[i] += step->tolerance.v[i];
	}
	return query_answer_of(
	    sweep_box(query->sweep, query->bodies, &box, query->clearance, query->tolerance, contact));
}

enum query_answer clearance_query_step(const struct clearance_query *query, const struct motion_step *step,
				       struct contact *contact)
{
	const struct span *span = &step->span;
	bool may_leave = step_may_leave_path(query->bodies->chain, step);
	const struct chord chord = {span->q0, span->q1, span->chord_error, may_leave ? &step->tolerance : NULL,
				    span->path, span->u0, span->u1, clearance_query_halve};

	if (step_is_box(step))
		return sweep_positions(query, step, contact);
	return clearance_query_chord(query, &chord, contact);
}
