/* checker.h - the check of one program under way: steps gather, are checked in batches, and findings come out. */
#ifndef FIVECHECK_CHECK_CHECKER_H
#define FIVECHECK_CHECK_CHECKER_H

#include <stdatomic.h>
#include <stdbool.h>

#include "base/diag.h"
#include "base/file_names.h"
#include "check/batch.h"
#include "check/block_log.h"
#include "check/options.h"
#include "check/scheduler.h"
#include "check/sink.h"
#include "check/stats.h"
#include "motion/events.h"
#include "scene/scene.h"

/* A place in the program; file NULL: nowhere yet. */
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
	struct sweep sweep;	/* for poses that stand still */
	struct cancel asked;	/* by all sweeps, now and then */
	atomic_flag telling;	/* a thread is telling progress */
	bool measures;	/* the smallest clearance of each pair */
	const char *file;	/* the program */
	long block;	/* number of the block that is being read */
	int tool;
	bool moved;
	bool failed;	/* something could not be decided: reported */
	bool found;	/* two bodies; without `all`, nothing later needs to be looked at */
	bool limit_found;
	bool exhausted;	/* a step would take more than options->effort: reported; the check ends with its batch */
	bool stopped;	/* by us or by the sink */
	bool broken_off;	/* since the last batch that was checked whole */
	bool skipped;	/* blocks of other shards since the last step of ours */
	axis_values position;
	double time, block_time;	/* where the last step ended */
	struct place last, checked;	/* the last step's block, and the last that was checked */
	struct motion_summary summary;	/* of what was read so far */
	long last_block;	/* the check ends with it */
	long steps;	/* of the block that is being read */
	/* With options->times: when reading that block began, seconds_check then, and s spent on clearances since. */
	double read_from, read_check, gauging;
};

/* s of a clock that only runs forward */
double checker_clock(void);

/* A cancel_fn whose context is a checker: shows progress in the middle of long work, and asks whether to go on. */
bool checker_asks(void *context);

/* Without options->all: is the first finding there? Then nothing later needs to be looked at. */
bool checker_has_enough(const struct checker *c);

/* Is this block one that this shard checks? */
bool checker_owns(const struct checker *c, long block);

/*
 * Checks the steps that have gathered, and tells what is known of all complete blocks. `timed`: the record of the block
 * that was just completed, if its times are to be taken; else NULL.
 */
void checker_process(struct checker *c, struct block_record *timed);

/* Looks at the pairs, those of the tool only if `tool_only`, as they stand at the current position. */
void checker_at_rest(struct checker *c, bool tool_only, int move);

#endif
