/*
 * scheduler.h - the checks of all pairs, and their distribution over threads. The distribution changes no result.
 */
#ifndef FIVECHECK_CHECK_SCHEDULER_H
#define FIVECHECK_CHECK_SCHEDULER_H

#include <stdbool.h>
#include <stddef.h>

#include "check/measured_blocks.h"
#include "check/pair_check.h"
#include "check/shared_loop.h"
#include "check/stats.h"

struct nearness;

/* One piece of work for a thread: a check over the whole batch, or a copy of the check over a part of the batch. */
struct task {
	struct pair_check *check;
	struct pair_check *copy;	/* owned; NULL: the check itself runs, over the whole batch */
	size_t from, to;	/* steps */
	long visits;	/* node pairs examined */
	long examined;	/* boxes and single steps examined */
};

struct scheduler {
	struct pair_check *checks;	/* in the order of the pairs */
	size_t count;
	struct sweep *sweeps;	/* one for each thread */
	int threads;
	struct shared_loop *loop;	/* an idle thread helps with it; NULL: only our own threads */
	long *visits;	/* node pairs that each check examined in the last batch */
	long work;	/* the sum of `visits` */
	long *costs;	/* of each check in the last batch, in node pairs */
	struct task *tasks;	/* of this batch */
	size_t *turns;	/* the order in which threads take the tasks */
	size_t task_count, task_capacity, turn_capacity;
	struct pair_results results;	/* of the last batch, of all checks in order */
	double *most;	/* measure_plan.most */
	size_t most_capacity;
	struct measured_blocks blocks;
	struct nearness *order;	/* the order in which pairs are measured if only the smallest clearance counts */
};

/* `cancel` is asked during a batch, from any thread. */
void scheduler_init(struct scheduler *scheduler, struct scene *scene, const struct check_options *options,
		    const struct cancel *cancel, struct pair_measuring measuring);
void scheduler_release(struct scheduler *scheduler);

/* Was the last batch so much work that threads share the next one? Not during a batch. */
bool scheduler_is_heavy(const struct scheduler *scheduler);

/* Adds a thread. Not during a batch. */
void scheduler_add_thread(struct scheduler *scheduler);

/*
 * Runs every active check over the batch and collects the results. They do not depend on the number of threads, because
 * only counts of work decide how it is divided. False: interrupted; the results are invalid.
 */
bool scheduler_run(struct scheduler *scheduler, const struct batch *batch, int tool,
		   const struct check_options *options);

/*
 * Measures the clearances in the batch's blocks with every active check (pair_measure). With
 * options->least_clearances only the smallest one of each block is exact, others may stay at the cap; then call it
 * after scheduler_run, else before. False: interrupted.
 */
bool scheduler_measure(struct scheduler *scheduler, const struct batch *batch, int tool,
		       const struct check_options *options);

/* Another tool is in the spindle: its pairs forget what was proved at the last position. */
void scheduler_change_tool(struct scheduler *scheduler);

/* Steps were left out: the next step does not begin at the end of the last one. */
void scheduler_jump(struct scheduler *scheduler);

/*
 * Adds up the counters, and the pairs that became unknown up to last_block, where the check ended. proven may be NULL.
 */
void scheduler_collect(struct scheduler *scheduler, const struct check_options *options, long last_block,
		       struct check_stats *stats, double *proven);

#endif
