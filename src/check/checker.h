/* checker.h - the state of a check: steps are collected into batches, batches are checked, findings are reported. */
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
#include "check/scheduler.h"
#include "check/sink.h"
#include "check/stats.h"
#include "check/stock_check.h"
#include "motion/events.h"
#include "scene/scene.h"

/* A place in the program. File NULL: no place yet. */
struct place {
	const char *file;
	long line;
};

/* A batch that is being checked, and what the check comes to if it ends with it. */
struct pending_batch {
	struct batch batch;
	struct block_page page;	/* the blocks that were completed in it */
	struct file_names opened;	/* files that were opened meanwhile, not told yet */
	struct event_copies heard;	/* what options->watch is told when the batches before are settled */
	long block;	/* the last block of the page, or the one that is being read */
	int tool;	/* in the spindle, during the whole batch */
	struct place last;	/* the last step's block */
	struct motion_summary summary;	/* of what was read so far */
	long blocks_checked;
	bool runs;	/* it has something to check */
	bool complete;	/* it was not broken off; then the next are valid */
	struct pair_check_result *results;	/* of all pairs in order */
	size_t result_count, result_capacity;
	double seconds, measuring;	/* the check took so long, and so much of that to measure clearances */
};

/* s */
#define GRACE_SECONDS 1.0

/* So many batches are being checked or wait for it, or for their results to be taken. */
enum { PENDING = 4 };

/*
 * With several threads the batches that were collected are checked in the background, one by one, while this thread
 * reads on and collects the next one: from the start, or from the batch on at which there is a thread to spare. All
 * else is this thread's: it takes the results in order. A batch with results is the last one that is checked until they
 * are taken, so that no more is checked than with one thread.
 */
struct checker {
	struct scene *scene;
	const struct check_options *options;
	const struct check_sink *sink;
	struct diag *diag;
	struct check_stats *stats;
	struct file_names names;
	struct block_log log;
	struct batch batch;	/* is being collected */
	struct file_names opened;	/* meanwhile, if batches before it are being checked */
	struct event_copies heard;	/* meanwhile, with a background */
	struct scheduler scheduler;	/* the background's while it has a batch to check */
	struct background second;
	struct background *background;	/* `second`; NULL: each batch is checked when it is collected */
	int borrowed;	/* spare threads that are in use */
	struct pending_batch pending[PENDING];	/* that of batch i is i % PENDING */
	size_t begun, settled;	/* batches: those between are the background's */
	struct pending_batch *settling;	/* whose results are being taken */
	struct stock_check stock;
	struct cutter_approach approach;
	struct sweep sweep;	/* for poses at which the axes stand still */
	struct cancel asked;	/* sweeps ask it again and again whether to stop */
	pthread_mutex_t telling;	/* for progress, and what it said: */
	double refused;	/* when it said to give up, by checker_clock; 0: it did not */
	bool counts_steps;	/* nothing is checked, recorded or watched: steps are not sent, but counted */
	bool measures;	/* measure the smallest clearance of each pair */
	const char *file;	/* the program */
	long block;	/* number of the block that is being read */
	long share, share_blocks;	/* the share of the blocks that it belongs to; how many of it were read */
	int tool;
	bool moved;
	bool failed;	/* something was not checked, or not decided at a standstill, and that was reported */
	bool found;	/* two bodies came too close; without `all` nothing later needs to be checked */
	bool limit_found;	/* without `all` the check ends with this block */
	bool exhausted;	/* one step needs more than options->effort: reported; the check ends with its batch */
	bool stopped;	/* by us or by the sink */
	bool broken_off;	/* the batch was not checked to its end */
	bool skipped;	/* blocks of other shards were left out since the last step of this shard */
	axis_values position;
	double time, block_time;	/* where the last step ended */
	struct place last, checked;	/* the last step's block; the last block that was checked */
	atomic_long checked_line;	/* the same for all threads */
	struct motion_summary summary;	/* of what was read so far */
	long last_block;	/* the check ends with it */
	long steps;	/* of the block that is being read */
	long number;	/* of the next step among all steps of the program */
	/*
	 * With options->times: when reading of that block began; seconds_check then; s spent since on block clearances.
	 */
	double read_from, read_check, measuring;
};

/* Seconds of a clock that never runs backwards. */
double checker_clock(void);

/*
 * A cancel_fn whose context is a checker. Reports progress during long work, and asks the caller whether to stop. If
 * progress says so, the work has GRACE_SECONDS to come to its end, so that its findings can be reported.
 */
bool checker_asks(void *context);

/* Reports progress. False: the check is to stop, now or since an earlier call. */
bool checker_goes_on(struct checker *c);

/* Is the first finding known, so that nothing later needs to be checked? Never with options->all. */
bool checker_has_enough(const struct checker *c);

/* Does this shard check the block that is being read? */
bool checker_owns(const struct checker *c);

/*
 * Is the block that was read, which moved the axes for so many seconds, the last one of a share? Only a block that
 * moves is: then the time tells the order of findings in two shares, which merge relies on.
 */
bool checker_ends_share(const struct checker *c, double seconds);

/* Goes on to the next block. */
void checker_end_block(struct checker *c, double seconds);

/*
 * Adds a finding in the move with this number, in a step of this class (0: the axes stand). `tolerance`: the control
 * may leave the path by so much, and the distance is measured; NULL: it may not.
 */
void checker_add_finding(struct checker *c, const struct block_finding *at, enum finding_kind kind, int move,
			 int step_class, const struct contact *found, const axis_values *tolerance);

/*
 * Logs the contacts of the batch. Without `all`, *last becomes the first step with a contact: what comes later does not
 * matter.
 */
void checker_take_results(struct checker *c, const struct pair_check_result *results, size_t count,
			  size_t *last);

/* Reports what could not be decided up to the step `last` of the batch. */
void checker_take_undecided(struct checker *c, const struct pair_check_result *results, size_t count,
			    size_t last);

/* Reports the findings whose blocks are complete, and the diagnostics that came before them. */
void checker_hand_on_findings(struct checker *c);

#endif
