/*
 * scheduler.h - the checks of all pairs, and how threads share them. The division of work among threads changes no
 * result.
 */
#ifndef FIVECHECK_CHECK_SCHEDULER_H
#define FIVECHECK_CHECK_SCHEDULER_H

#include <stdbool.h>
#include <stddef.h>

#include "check/pair_check.h"
#include "check/shared_loop.h"
#include "check/stats.h"

struct nearness;

/* One piece of work for a thread: a check over the whole batch, or a copy of the check over a part of the batch. */
struct task {
	struct pair_check *check;
	struct pair_check *copy;	/* owned; NULL: the check itself runs, over the whole batch */
	size_t from, to;	/* steps */
	long visits;	/* node pairs that were looked at */
};

struct scheduler {
	struct pair_check *checks;	/* in the order of the pairs */
	size_t count;
	struct sweep *sweeps;	/* one a thread */
	int threads;
	struct shared_loop *loop;	/* one thread helps when it has nothing else to do; NULL: all are ours */
	long *visits;	/* node pairs that each check looked at in the last batch */
	long work;	/* the sum of them */
	struct task *tasks;	/* of this batch */
	size_t task_count, task_capacity;
	struct pair_check_result *results;	/* of the last batch, of all checks in order */
	size_t result_count, result_capacity;
	double *most;	/* mm: of each step's block: a larger clearance is of no interest (pair_check_measure) */
	enum measure_wish *wishes;	/* of each step (measure_plan) */
	size_t most_capacity, wish_capacity;
	long spare_effort;	/* node pairs that measuring may still look at (measure_plan) */
	long short_effort;	/* as many more, if the program turns out to be short */
	double block_price;	/* node pairs that a measured block takes: a running mean */
	struct nearness *order;	/* in which pairs are measured where only the least clearance counts */
};

/* cancel is asked during a batch, from any thread. */
void scheduler_init(struct scheduler *scheduler, struct scene *scene, const struct check_options *options,
		    const struct cancel *cancel, struct pair_measuring measuring);
void scheduler_release(struct scheduler *scheduler);

/* Did the last batch take so much work that threads share the next one? Not during a batch. */
bool scheduler_is_heavy(const struct scheduler *scheduler);

/* From now on one thread more may work. Not during a batch. */
void scheduler_add_thread(struct scheduler *scheduler);

/*
 * Runs every active check over the batch and collects the results. They do not depend on the number of threads, because
 * counts of work alone decide what is divided. False: interrupted; then the results are invalid.
 */
bool scheduler_run(struct scheduler *scheduler, const struct batch *batch, int tool,
		   const struct check_options *options);

/*
 * Measures the clearances in the batch's blocks with every active check (pair_check_measure). With
 * options->least_clearances the smallest one of each block is that of the block, and others may be left at the cap;
 * then call it after scheduler_run, else before. False: interrupted.
 */
bool scheduler_measure(struct scheduler *scheduler, const struct batch *batch, int tool,
		     const struct check_options *options);

/* Another tool is in the spindle: its pairs forget what was proved at the last position. */
void scheduler_change_tool(struct scheduler *scheduler);

/*
 * Steps were left out: the next step does not begin where the last one ended, and nothing is known of the motion
 * between.
 */
void scheduler_jump(struct scheduler *scheduler);

/*
 * Adds up the counters, and the pairs that became unknown up to last_block, which ended the check. proven may be NULL.
 */
void scheduler_collect(struct scheduler *scheduler, const struct check_options *options, long last_block,
		       struct check_stats *stats, double *proven);

#endif
