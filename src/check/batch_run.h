/* batch_run.h - checks the batches of a checker, at once or in the background, and settles them in their order. */
#ifndef FIVECHECK_CHECK_BATCH_RUN_H
#define FIVECHECK_CHECK_BATCH_RUN_H

#include "check/checker.h"

/*
 * Between these two calls batches may be checked in the background. Call checker_end_threads after all begun batches
 * are settled.
 */
void checker_start_threads(struct checker *c);
void checker_end_threads(struct checker *c);

/*
 * Begins to check the collected steps, and reports the known results of earlier batches. Steps collected from now on
 * belong to the next batch.
 */
void checker_begin(struct checker *c);

/* Waits for the results of all begun batches, and reports everything about the blocks that are complete. */
void checker_settle(struct checker *c);

/*
 * checker_begin and checker_settle: afterwards all collected steps are checked and reported. `timed` is the record of
 * the block that was just completed if its times are needed; else NULL.
 */
void checker_process(struct checker *c, struct block_record *timed);

void checker_release_pending(struct checker *c);

#endif
