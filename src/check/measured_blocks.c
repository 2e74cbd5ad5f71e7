#include "check/measured_blocks.h"

#include <stdlib.h>

#include "base/mem.h"

/*
 * If only least clearances are measured, the measurement may visit this number of node pairs plus a share of those that
 * the check itself visits, and SHORT_EFFORT more in a program with fewer than SHORT_PROGRAM steps before its first tool
 * change. After that the curve shows what the check has proved. So a short program gets a sharp curve, and for a long
 * one the curve costs little more than the check, however close its bodies stay to each other.
 */
#define MEASURING_EFFORT 40000L
#define SHORT_EFFORT 2000000L
#define SHORT_PROGRAM 1000L
#define MEASURING_SHARE 0.15

/* The weight of the last batch in the running mean of the price of a measured block. */
#define PRICE_SHARE 0.5

/*
 * The blocks that are measured if only least clearances are measured: every block within this number of steps from the
 * start of the program, then every second one for as many steps, then every fourth one for twice as many, and so on.
 * They give the curve of a report.
 */
#define SINGLE_STEPS 512L

void measured_blocks_init(struct measured_blocks *blocks)
{
	*blocks = (struct measured_blocks){.spare_effort = MEASURING_EFFORT, .short_effort = SHORT_EFFORT};
}

void measured_blocks_release(struct measured_blocks *blocks)
{
	free(blocks->wishes);
	blocks->wishes = NULL;
}

/* The number of blocks of the batch whose number is a multiple of the stride. */
static long blocks_at(const struct batch *batch, long stride)
{
	const long first = batch->steps[0].block, last = batch->steps[batch->step_count - 1].block;

	return (last + 1) / stride - first / stride;
}

/* The smallest stride of measured blocks that the remaining effort allows in this batch. */
static long affordable_stride(const struct measured_blocks *blocks, const struct batch *batch)
{
	long stride = 1;

	while (blocks_at(batch, stride) > 1 &&
	       (double)blocks_at(batch, stride) * blocks->block_price > (double)blocks->spare_effort)
		stride *= 2;
	return stride;
}

void measured_blocks_select(struct measured_blocks *blocks, const struct batch *batch, long checked)
{
	long stride;

	blocks->spare_effort += (long)(MEASURING_SHARE * (double)checked);
	if (batch->steps[batch->step_count - 1].number < SHORT_PROGRAM) {
		blocks->spare_effort += blocks->short_effort;
		blocks->short_effort = 0;
	}
	blocks->effort_before = blocks->spare_effort;
	blocks->wishes =
	    mem_grow(blocks->wishes, &blocks->wish_capacity, batch->step_count, sizeof(*blocks->wishes));
	stride = affordable_stride(blocks, batch);
	for (size_t i = 0; i < batch->step_count; i++) {
		while (batch->steps[i].number / SINGLE_STEPS >= stride)
			stride *= 2;
		blocks->wishes[i] = (batch->steps[i].block + 1) % stride == 0 ? MEASURE_CURVE : MEASURE_NOTHING;
	}
}

void measured_blocks_add_nearest(struct measured_blocks *blocks, const struct batch *batch, long block)
{
	for (size_t i = 0; i < batch->step_count && block >= 0; i++)
		if (batch->steps[i].block == block)
			blocks->wishes[i] = MEASURE_NEAREST;
}

void measured_blocks_count(struct measured_blocks *blocks, const struct batch *batch)
{
	long last = -1;

	blocks->count = 0;
	for (size_t i = 0; i < batch->step_count; i++) {
		blocks->count += blocks->wishes[i] != MEASURE_NOTHING && batch->steps[i].block != last;
		last = batch->steps[i].block;
	}
}

void measured_blocks_done(struct measured_blocks *blocks)
{
	const double spent = (double)(blocks->effort_before - blocks->spare_effort);

	if (blocks->count > 0)
		blocks->block_price += PRICE_SHARE * (spent / (double)blocks->count - blocks->block_price);
}
