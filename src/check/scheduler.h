/* crew.h - the runners of all pairs, and the threads that take them through a batch. */
#ifndef FIVECHECK_CHECK_CREW_H
#define FIVECHECK_CHECK_CREW_H

#include <stdbool.h>
#include <stddef.h>

#include "check/runner.h"

/* What one thread does at a time: a runner over the whole batch, or over a part of it with a copy of the runner. */
struct task {
	struct runner *runner;
	struct runner *copy;	/* owned; NULL: the runner itself goes over the whole batch */
	size_t from, to;	/* steps */
};

struct crew {
	struct runner *runners;	/* in the order of the pairs */
	size_t count;
	struct sweep *sweeps;	/* one a thread */
	int threads;
	long *visits;	/* node pairs that each runner looked at in the last batch */
	long work;	/* the sum of them */
	struct task *tasks;	/* of this batch */
	size_t task_count, task_capacity;
	struct runner_result *results;	/* of the last batch, of all runners in order */
	size_t result_count, result_capacity;
};

/* measure: as in runner_init. False: a mesh is faulty, reported. */
bool crew_init(struct crew *crew, struct scene *scene, const struct check_options *options, bool measure,
	       struct diag *diag);
void crew_release(struct crew *crew);

/*
 * Sends every active runner through the batch and gathers the results. They do
 * not depend on the number of threads: what is split among them is decided by
 * counts of work alone. False: broken off, the results are worth nothing.
 */
bool crew_run(struct crew *crew, const struct batch *batch, int tool, const struct check_options *options);

/*
 * Measures with every active runner what clearance remains in the batch's blocks (runner_gauge); after
 * crew_run. False: broken off.
 */
bool crew_gauge(struct crew *crew, const struct batch *batch, int tool, const struct check_options *options);

/* Another tool is in the spindle: what its pairs knew of their position holds no longer. */
void crew_change_tool(struct crew *crew);

/* The next steps do not begin where the last ones ended, and nothing is known of what was between. */
void crew_jump(struct crew *crew);

/* Adds up the counters, and what is unknown up to the block that ended the check; proven may be NULL. */
void crew_collect(const struct crew *crew, long last_block, struct check_stats *stats, double *proven);

#endif
