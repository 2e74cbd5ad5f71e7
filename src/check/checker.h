/* checker.h - the state of a check: collects steps into batches, checks the batches, and reports the findings. */
#ifndef FIVECHECK_CHECK_CHECKER_H
#define FIVECHECK_CHECK_CHECKER_H

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>

#include "base/diag.h"
#include "base/file_names.h"
#include "check/background.h"
#include "check/batch.h"
#include "check/block_log.h"
#include "check/cutter_approach.h"
#include "check/event_copies.h"
#include "check/options.h"
#include "check/pending_batch.h"
#include "check/scheduler.h"
#include "check/sink.h"
#include "check/stats.h"
#include "check/stock_check.h"
#include "motion/events.h"
#include "scene/scene.h"

/* s */
#define GRACE_SECONDS 1.0

/*
 * The number of batches that are being checked, wait for the check, or wait for their results to be taken. Measured:
 * with 12, a program of 34,000 blocks takes a fifth more time, because new memory costs time; one of 800,000 takes 3
 * percent less.
 */
enum { PENDING = 4 };

/* The state of the program at the end of what was read. */
struct program_state {
	long block;	/* number of the block being read */
	long share, share_blocks;	/* its share of the blocks; number of blocks of that share read so far */
	long steps;	/* of the block being read */
	long next_step;	/* number of the next step among all steps of the program */
	int tool;
	bool moved;
	bool skipped;	/* blocks of other shards follow the last step of this shard */
	axis_values position;
	double time, block_time;	/* where the last step ended */
	struct place last;	/* the last step's block */
	struct motion_summary summary;
};

/* With options->times: the time that the block being read takes. */
struct block_timing {
	double read_from;	/* checker_clock at the start of reading */
	double check_before;	/* stats->seconds_check then */
	double measuring;	/* s spent on clearances since then */
};

/* The batches that are being checked or wait. Batch i is items[i % PENDING]. */
struct pending_batches {
	struct pending_batch items[PENDING];
	size_t begun, settled;	/* numbers of batches; those between belong to the background */
	struct pending_batch *settling;	/* the batch whose results are being taken */
};

/* Why and where the check ends. */
struct check_end {
	bool failed;	/* something was not checked or not decided, and this was reported */
	bool found;	/* two bodies came too close; without `all` the check ends here */
	bool limit_found;	/* without `all` the check ends with this block */
	bool exhausted;	/* a step needs more than options->effort: reported; the check ends with this step */
	long exhausted_step;	/* its number among all steps of the program */
	bool stopped;	/* by us or by the sink */
	bool broken_off;	/* the batch was not checked to its end */
	long last_block;	/* the check ends with it */
};

/*
 * With several threads, a background thread checks the collected batches one by one, while this thread reads on and
 * collects the next one. The background starts at once, or as soon as there is a spare thread. This thread does
 * everything else: it takes the results in order. After a batch with results the background waits until they are taken,
 * so that it checks no more than a single thread would.
 */
struct checker {
	/* Given by the caller. */
	struct scene *scene;
	const struct check_options *options;
	const struct check_sink *sink;
	struct diag *diag;
	struct check_stats *stats;
	const char *file;	/* the program */
	bool counts_steps;	/* nothing is checked, recorded or watched: steps are only counted */
	bool measures;	/* measure the smallest clearance of each pair */

	struct program_state program;
	struct block_timing timing;

	/* The batch that is being collected, and those that are being checked. */
	struct batch batch;
	struct file_names opened;	/* while it is collected, if earlier batches are being checked */
	struct event_copies heard;	/* while it is collected, with a background */
	struct pending_batches pending;

	/* The checks, and the threads that run them. */
	struct scheduler scheduler;	/* belongs to the background while it checks a batch */
	struct stock_check stock;
	struct cutter_approach approach;
	struct sweep sweep;	/* for poses with the axes at rest */
	struct background second;
	struct background *background;	/* &second; NULL: this thread checks each batch itself */
	int borrowed;	/* spare threads in use */
	struct cancel asked;	/* asked by sweeps whether to stop */
	pthread_mutex_t telling;	/* for the progress callback and `refused` */
	double refused;	/* checker_clock when the callback said to give up; 0: it did not */

	/* The results. */
	struct file_names names;
	struct block_log log;
	struct place checked;	/* the last block that was checked */
	atomic_long checked_line;	/* the line of `checked`, for all threads */
	bool *undecided;	/* pairs for which checker_say_undecided was called; NULL: none */
	struct check_end end;
};

/* Seconds of a monotonic clock. */
double checker_clock(void);

/*
 * A cancel_fn whose context is a checker. Reports progress during long work, and asks the caller whether to stop. If
 * the caller says so, the work has GRACE_SECONDS to finish, so that its findings can be reported.
 */
bool checker_asks(void *context);

/* Reports progress. False: stop the check. */
bool checker_goes_on(struct checker *c);

/* Is the first finding known, so that nothing later must be checked? Never with options->all. */
static inline bool checker_has_enough(const struct checker *c)
{
	return c->end.found && !c->options->all;
}

/* Does this shard check the block being read? */
static inline bool checker_owns(const struct checker *c)
{
	const struct check_options *options = c->options;

	return options->shards < 2 || c->program.share % options->shards == options->shard - 1;
}

/*
 * Is the block being read, whose motion takes `seconds`, the last one of its share? Only a block that moves can be: the
 * time then gives the order of findings in two shares, which merge needs.
 */
bool checker_ends_share(const struct checker *c, double seconds);

/* Begins the next block. */
void checker_end_block(struct checker *c, double seconds);

/*
 * Adds a finding in the move with this number, in a step of this class (0: the axes are at rest). `tolerance`: the
 * path tolerance of the control, and the distance is measured; NULL: there is none.
 */
void checker_add_finding(struct checker *c, const struct block_finding *at, enum finding_kind kind, int move,
			 int step_class, const struct contact *found, const axis_values *tolerance);

/* The step of the batch with which these results end the check, at the latest `last`. Later steps do not matter. */
size_t checker_last_step(const struct checker *c, const struct pair_results *results, size_t last);

/* Logs the contacts, and reports what was not decided, up to the step `last` of the batch. */
void checker_take_results(struct checker *c, const struct pair_results *results, size_t last);

/*
 * Reports that the pair cannot be decided because of rounding, once for the whole program: the message names no block.
 * `order` as in struct block_finding.
 */
void checker_say_undecided(struct checker *c, size_t pair, long block, long order);

/* Reports the findings whose blocks are complete, and the diagnostics that came before them. */
void checker_hand_on_findings(struct checker *c);

#endif
