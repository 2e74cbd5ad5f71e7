/* strategy.h - takes a pair through a program's steps: decides what to ask of its proof, and when. */
#ifndef FIVECHECK_CHECK_CERTIFIED_STRATEGY_H
#define FIVECHECK_CHECK_CERTIFIED_STRATEGY_H

#include <stdbool.h>

#include "check/batch.h"
#include "check/certified/proof.h"
#include "motion/motion.h"

/* The strategy changes how long the answers take, never the answers: those are the proof's (proof.h). */
struct strategy {
	struct pair_proof proof;
	bool measures;	/* the smallest clearance */
	int steps_to_next_query;	/* steps before the next distance query is worth its time */
	int backoff;	/* how many steps to wait after the next query that does not pay */
	bool distance_pays;	/* false: the last step had to be swept */
	size_t merge_count;	/* how many steps were last tried at once; 0: none yet */
	long sweep_visits;	/* node pairs that sweeps looked at since the last sharp query */
	long covered_steps, queries;
};

/*
 * measure: prove not just the clearance but as much as there is, to within
 * MEASURE_SHARE; it takes more time. The strategy must stay where it is from here on.
 */
void strategy_init(struct strategy *strategy, const struct body_pair *bodies, double clearance, double tolerance,
		   bool measure);

/* A strategy that measures does not look for more than `most` mm; that counts as proven where it was never measured. */
void strategy_cap(struct strategy *strategy, double most);

/*
 * A part of the steps can be followed by a fork, without what led to them. Its
 * findings are the whole's; strategy_join, part by part in order, brings back the
 * rest: counters, the smallest clearance, and the state behind the last part.
 */
void strategy_fork(const struct strategy *whole, struct strategy *part);
void strategy_join(struct strategy *whole, const struct strategy *part);

/* mm: more than this remained in every step so far; INFINITY: it was never measured. */
double strategy_proven(const struct strategy *strategy);

/* The next step does not begin where the last one ended, or the pair is not apart there. */
void strategy_forget_position(struct strategy *strategy);

/*
 * Takes many steps at once, of which all positions are between low and high, give or take `errors`,
 * and the last is `end`, if the proof has a budget for them all; else false, and nothing is taken.
 */
bool strategy_advance_box(struct strategy *strategy, const axis_values *low, const axis_values *high,
			  const struct position_errors *errors, const axis_values *end, size_t steps);

/*
 * Where distances do not pay, has several of the `count` steps ahead proved in one go. Returns how many; 0: none,
 * then they have to be taken one by one.
 */
size_t strategy_advance_chord(struct strategy *strategy, struct sweep *sweep, const struct batch_step *steps,
			      size_t count);

enum query_answer strategy_advance_step(struct strategy *strategy, struct sweep *sweep, const struct motion_step *step,
					struct contact *contact);

#endif
