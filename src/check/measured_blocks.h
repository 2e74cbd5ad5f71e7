/*
 * measured_blocks.h - selects the blocks whose clearance is measured if only least clearances are measured, and the
 * effort for it. If every block is measured, the selection is not used.
 */
#ifndef FIVECHECK_CHECK_MEASURED_BLOCKS_H
#define FIVECHECK_CHECK_MEASURED_BLOCKS_H

#include <stddef.h>

#include "check/batch.h"
#include "check/pair_measure.h"

struct measured_blocks {
	enum measure_wish *wishes;	/* of the batch (measure_plan.wishes) */
	size_t wish_capacity;
	long spare_effort;	/* node pairs that measuring may still examine (measure_plan) */
	long short_effort;	/* as many more, if the program turns out to be short */
	long effort_before;	/* spare_effort when the blocks of this batch were selected */
	long count;	/* of the blocks selected in this batch */
	double block_price;	/* node pairs per measured block: a running mean */
};

void measured_blocks_init(struct measured_blocks *blocks);
void measured_blocks_release(struct measured_blocks *blocks);

/* Begins a batch, whose check has examined this number of node pairs. Selects blocks at regular intervals. */
void measured_blocks_select(struct measured_blocks *blocks, const struct batch *batch, long checked);

/* Selects this block of the batch too (-1: none): it lowered the smallest clearance of a pair. */
void measured_blocks_add_nearest(struct measured_blocks *blocks, const struct batch *batch, long block);

/* Ends the selection: counts the selected blocks. */
void measured_blocks_count(struct measured_blocks *blocks, const struct batch *batch);

/* The selected blocks were measured: learns their price. */
void measured_blocks_done(struct measured_blocks *blocks);

#endif
