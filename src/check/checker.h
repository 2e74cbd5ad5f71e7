/* checker.h - the state of a check: steps are collected into batches, batches are checked, findings are reported. */
#ifndef FIVECHECK_CHECK_CHECKER_H
#define FIVECHECK_CHECK_CHECKER_H

#include <stdatomic.h>
#include <stdbool.h>

#include "base/diag.h"
#include "base/file_names.h"
#include "check/batch.h"
#include "check/block_log.h"
#include "check/cutter_approach.h"
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

struct checker {
	struct scene *scene;
	const struct check_options *options;
	const struct check_sink *sink;
	struct diag *diag;
	struct check_stats *stats;
	struct file_names names;
	struct block_log log;
	struct scheduler scheduler;
	struct batch batch;
	struct stock_check stock;
	struct cutter_approach approach;
	struct sweep sweep;	/* for poses at which the axes stand still */
	struct cancel asked;	/* sweeps ask it again and again whether to stop */
	atomic_flag telling;	/* a thread is reporting progress */
	bool measures;	/* measure the smallest clearance of each pair */
	const char *file;	/* the program */
	long block;	/* number of the block that is being read */
	int tool;
	bool moved;
	bool failed;	/* something could not be decided, and that was reported */
	bool found;	/* two bodies came too close; without `all` nothing later needs to be checked */
	bool limit_found;
	bool exhausted;	/* one step needs more than options->effort: reported; the check ends with its batch */
	bool stopped;	/* by us or by the sink */
	bool broken_off;	/* the batch was not checked to its end */
	bool skipped;	/* blocks of other shards were left out since the last step of this shard */
	axis_values position;
	double time, block_time;	/* where the last step ended */
	struct place last, checked;	/* the last step's block; the last block that was checked */
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

/* A cancel_fn whose context is a checker. Reports progress during long work, and asks the caller whether to stop. */
bool checker_asks(void *context);

/* Is the first finding known, so that nothing later needs to be checked? Never with options->all. */
bool checker_has_enough(const struct checker *c);

/* Does this shard check the block? */
bool checker_owns(const struct checker *c, long block);

/*
 * Checks the collected steps, and reports what is known of all complete blocks. `timed` is the record of the block that
 * was just completed if its times are wanted; else NULL.
 */
void checker_process(struct checker *c, struct block_record *timed);

/* Checks the pairs at the current position, where the axes stand still. tool_only: only the pairs of the tool. */
void checker_at_rest(struct checker *c, bool tool_only, int move);

/* Checks at the current position the cutters that may be in the part only while they cut. */
void checker_spindle_stops(struct checker *c, int move);

#endif
