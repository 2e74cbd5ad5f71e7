/* batch_run.h - a checker's batches: they are checked, at once or in the background, and settled in their order. */
#ifndef FIVECHECK_CHECK_BATCH_RUN_H
#define FIVECHECK_CHECK_BATCH_RUN_H

#include "check/checker.h"

/*
 * Between these two batches may be checked in the background. The second one is called when all that was begun is
 * settled.
 */
void checker_start_threads(struct checker *c);
void checker_end_threads(struct checker *c);

/*
 * Begins to check the collected steps, and reports what is known by now of the batches before. What is collected from
 * now on belongs to the next batch.
 */
void checker_begin(struct checker *c);

/* Ends what checker_begin began: waits for the results, and reports what is known of all blocks that are complete. */
void checker_settle(struct checker *c);

/*
 * Begins and settles: afterwards all that was collected is checked and reported. `timed` is the record of the block
 * that was just completed if its times are wanted; else NULL.
 */
void checker_process(struct checker *c, struct block_record *timed);

void checker_release_pending(struct checker *c);

#endif
