/* scheduler.h - the checks of all pairs, and the threads that take them through a batch. */
#ifndef FIVECHECK_CHECK_SCHEDULER_H
#define FIVECHECK_CHECK_SCHEDULER_H

#include <stdbool.h>
#include <stddef.h>

#include "check/pair_check.h"
#include "check/stats.h"

/* What one thread does at a time: it takes a check over the whole batch, or a copy of it over a part of the batch. */
struct job {
	struct pair_check *check;
	struct pair_check *copy;	/* owned; NULL: the check itself goes over the whole batch */
	size_t from, to;	/* steps */
	long visits;	/* node pairs that were looked at */
};

struct scheduler {
	struct pair_check *checks;	/* in the order of the pairs */
	size_t count;
	struct sweep *sweeps;	/* one a thread */
	int threads;
	long *visits;	/* node pairs that each check looked at in the last batch */
	long work;	/* the sum of them */
	struct job *jobs;	/* of this batch */
	size_t job_count, job_capacity;
	struct pair_check_result *results;	/* of the last batch, of all checks in order */
	size_t result_count, result_capacity;
};

/* cancel: asked in the middle of a batch, from any thread. measure: as in pair_check_init. False: a mesh is faulty, reported. */
bool scheduler_init(struct scheduler *scheduler, struct scene *scene, const struct check_options *options,
		    const struct cancel *cancel, bool measure, struct diag *diag);
void scheduler_release(struct scheduler *scheduler);

/*
 * Sends every active check through the batch and gathers the results. They do
 * not depend on the number of threads: what is split among them is decided by
 * counts of work alone. False: broken off, the results are worth nothing.
 */
bool scheduler_run(struct scheduler *scheduler, const struct batch *batch, int tool,
		   const struct check_options *options);

/*
 * Measures with every active check what clearance remains in the batch's blocks (pair_check_measure); after
 * scheduler_run. False: broken off.
 */
bool scheduler_gauge(struct scheduler *scheduler, const struct batch *batch, int tool,
		     const struct check_options *options);

/* Another tool is in the spindle: what its pairs knew of their position holds no longer. */
void scheduler_change_tool(struct scheduler *scheduler);

/* The next steps do not begin where the last ones ended, and nothing is known of what was between. */
void scheduler_jump(struct scheduler *scheduler);

/* Adds up the counters, and what is unknown up to the block that ended the check; proven may be NULL. */
void scheduler_collect(const struct scheduler *scheduler, long last_block, struct check_stats *stats, double *proven);

#endif
