/* pending_batch.h - a batch that is being checked, with the state of the reader at its end. */
#ifndef FIVECHECK_CHECK_PENDING_BATCH_H
#define FIVECHECK_CHECK_PENDING_BATCH_H

#include <stdbool.h>

#include "base/file_names.h"
#include "check/batch.h"
#include "check/block_log.h"
#include "check/event_copies.h"
#include "check/scheduler.h"
#include "motion/events.h"

/* A place in the program. File NULL: none yet. */
struct place {
	const char *file;
	long line;
};

/* The state of the reader is the result of the check if the check ends with this batch. */
struct pending_batch {
	struct batch batch;
	struct block_page page;	/* the blocks completed in this batch */
	struct file_names opened;	/* files opened meanwhile, not reported yet */
	struct event_copies heard;	/* events for options->watch, sent when the earlier batches are settled */
	long block;	/* the last block of the page, or the block being read */
	int tool;	/* in the spindle, during the whole batch */
	struct place last;	/* the last step's block */
	struct motion_summary summary;	/* of what was read so far */
	long blocks_checked;
	bool runs;	/* it has steps to check */
	bool complete;	/* it was checked to its end; only then the next batch is valid */
	struct pair_results results;	/* of all pairs, in their order */
	double seconds, measuring;	/* duration of the check; the part of it that measured clearances */
};

/* Copies the scheduler's results, because it may begin the next batch. */
void pending_batch_keep_results(struct pending_batch *pending, const struct scheduler *scheduler);

/* Frees the storage of a pending batch, also of one that was never used (all 0). */
void pending_batch_release(struct pending_batch *pending);

#endif
