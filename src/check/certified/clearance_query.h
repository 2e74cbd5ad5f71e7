/*
 * clearance_query.h - the exact query: does a pair keep its distance along a step? The quick proofs only save calls of
 * it.
 */
#ifndef FIVECHECK_CHECK_CERTIFIED_CLEARANCE_QUERY_H
#define FIVECHECK_CHECK_CERTIFIED_CLEARANCE_QUERY_H

#include <stdbool.h>

#include "motion/motion.h"
#include "scene/sweep.h"

/* Borrows everything. */
struct clearance_query {
	struct sweep *sweep;
	const struct body_pair *bodies;
	double clearance, tolerance;	/* mm, as in sweep_chord */
	bool any;	/* any contact will do; else the first one is needed */
	long box_visits;	/* the most node pairs to examine if the path is not known (PATH_BOX); 0: no limit */
};

enum query_answer {
	QUERY_CLEAR, /* proved: at every instant farther apart than clearance plus path displacement */
	/* *contact is the first instant, its s is the step's; at most clearance + displacement + tolerance apart */
	QUERY_CONTACT,
	QUERY_UNDECIDED
};

static inline enum query_answer query_answer_of(enum sweep_answer answer)
{
	return answer == SWEEP_APART ? QUERY_CLEAR : answer == SWEEP_CONTACT ? QUERY_CONTACT : QUERY_UNDECIDED;
}

/* The chord.halve of a piece of a path (chord.curve). */
void clearance_query_halve(const struct chord *whole, struct chord *first, struct chord *second);

enum query_answer clearance_query_chord(const struct clearance_query *query, const struct chord *chord,
					struct contact *contact);

/* The same along a step, with its path tolerance. */
enum query_answer clearance_query_step(const struct clearance_query *query, const struct motion_step *step,
				       struct contact *contact);

#endif
