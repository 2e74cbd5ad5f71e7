/* strategy.h - follows one pair of bodies through a program's steps and proves that it stays apart. */
#ifndef FIVECHECK_CHECK_CERTIFIED_STRATEGY_H
#define FIVECHECK_CHECK_CERTIFIED_STRATEGY_H

#include <stdbool.h>

#include "check/batch.h"
#include "check/certified/kept_budgets.h"
#include "motion/motion.h"
#include "scene/coherence.h"
#include "scene/scene.h"

/* How a pair came through one step. */
enum query_answer {
	QUERY_CLEAR,
	QUERY_CONTACT,	/* *contact: its s is the step's */
	QUERY_UNDECIDED
};

/* What is known of a pair from step to step. */
struct strategy {
	struct body_pair bodies;
	double clearance;	/* mm: what must remain */
	double target;	/* mm: what is being proven: the clearance, or more when the smallest one is measured */
	double tolerance;	/* mm: e */
	bool measures;	/* the smallest clearance */
	struct coherence coherence;
	struct kept_budgets budgets;
	bool clear_at_end;	/* the pair is apart where the last step ended */
	bool position_unknown;	/* steps were left out since the last one */
	int steps_to_next_query;	/* steps before the next distance query is worth its time */
	int backoff;	/* how long to wait after the next query that does not pay */
	bool sweeps;	/* the last step had to be swept, as distances do not pay */
	size_t merge_count;	/* how many steps to try at once; 0: not tried yet */
	long sweep_visits;	/* that sweeps took since the last sharp query */
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
 * Takes many steps at once, of which all positions are between low and high
 * and the last is `end`, if the budget covers them all; else false, and nothing is taken.
 */
bool strategy_advance_box(struct strategy *strategy, const axis_values *low, const axis_values *high,
		   const struct position_errors *errors, const axis_values *end, size_t steps);

/*
 * Where distances do not pay, proves several of the `count` steps ahead in one go: how many; 0: none,
 * then they have to be taken one by one.
 */
size_t strategy_advance_chord(struct strategy *strategy, struct sweep *sweep, const struct batch_step *steps, size_t count);

enum query_answer strategy_advance_step(struct strategy *strategy, struct sweep *sweep, const struct motion_step *step,
			   struct contact *contact);

#endif
