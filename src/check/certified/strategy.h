/* strategy.h - takes a pair through the steps of a program: decides which proofs to try, and when. */
#ifndef FIVECHECK_CHECK_CERTIFIED_STRATEGY_H
#define FIVECHECK_CHECK_CERTIFIED_STRATEGY_H

#include <stdbool.h>

#include "check/batch.h"
#include "check/certified/plane_account.h"
#include "check/certified/proof.h"
#include "motion/motion.h"

/* How exactly the smallest clearance is measured. */
enum strategy_measure {
	STRATEGY_PROVES,	/* not at all: only the required distance is proved */
	STRATEGY_MEASURES,
	STRATEGY_MEASURES_COARSELY	/* less exactly, in less time */
};

/* The strategy changes how long the answers take, never the answers: those come from the proof (proof.h). */
struct strategy {
	struct pair_proof proof;
	double measure_share;	/* about the share of the clearance to be proved; 0: do not measure */
	int steps_to_next_query;	/* steps to wait before the next distance query */
	int backoff;	/* steps to wait after the next unsuccessful query */
	bool distance_pays;	/* false: the last step had to be swept */
	size_t merge_count;	/* number of steps merged last time; 0: none yet */
	struct plane_account planes;
	long sweep_visits;	/* node pairs examined by sweeps since the last sharp query (strategy.c) */
	long covered_steps, plane_steps;	/* proved by a budget, by travelling planes */
	long queries;
};

/*
 * `measure`: prove not only the required clearance, but the existing one, to within a share. This takes more time. The
 * strategy must not be moved afterwards.
 */
void strategy_init(struct strategy *strategy, const struct body_pair *bodies, double clearance, double tolerance,
		   enum strategy_measure measure);
void strategy_release(struct strategy *strategy);

/* A strategy that measures stops at `most` mm: it then counts `most` as proven. */
void strategy_cap(struct strategy *strategy, double most);

/*
 * A fork checks a part of the steps without knowing the steps before. Its findings count for the whole. strategy_join,
 * called for the parts in their order, brings back the rest: counters, the smallest clearance, and the state after the
 * last part. It releases the part.
 */
void strategy_fork(const struct strategy *whole, struct strategy *part);
void strategy_join(struct strategy *whole, struct strategy *part);

/* mm: the smallest clearance proved so far; INFINITY: none was measured. */
double strategy_proven(const struct strategy *strategy);

/* Halves the effort for a step whose path is not known (PATH_BOX) this often. */
void strategy_limit_boxes(struct strategy *strategy, int halvings);

/* Call it if the next step does not begin where the last one ended, or if the pair is not apart there. */
void strategy_forget_position(struct strategy *strategy);

/*
 * Checks many steps at once: all positions are between low and high, plus or minus `errors`, and the last one is `end`.
 * False: neither a budget nor planes cover them, and nothing was checked. thorough: also try earlier budgets, and
 * search new planes if that may pay.
 */
bool strategy_advance_box(struct strategy *strategy, const axis_values *low, const axis_values *high,
			  const struct position_errors *errors, const axis_values *end, size_t steps, bool thorough);

/*
 * If distance queries do not pay, tries to prove several of the next `count` steps at once. Returns their number; 0:
 * none, and the caller must check the steps one by one.
 */
size_t strategy_advance_chord(struct strategy *strategy, struct sweep *sweep, const struct batch_step *steps,
			      size_t count);

enum query_answer strategy_advance_step(struct strategy *strategy, struct sweep *sweep, const struct motion_step *step,
					struct contact *contact);

#endif
