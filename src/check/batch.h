/* batch.h - copies of some thousand steps of a program, to be checked pair by pair. */
#ifndef FIVECHECK_CHECK_BATCH_H
#define FIVECHECK_CHECK_BATCH_H

#include <stdbool.h>
#include <stddef.h>

#include "check/path_copies.h"
#include "check/step.h"
#include "motion/events.h"

/* A step and its place in the program. */
struct batch_step {
	struct motion_step motion;	/* its path is a copy in the batch */
	long block;
	long number;	/* among all steps of the program, from 0 */
	long share;	/* SHARE_BLOCKS: the number of its block's share */
	bool beyond;	/* an axis is past a limit, or the path tolerance may take it past */
};

/* The number of steps in a chunk, and in each of its pieces. */
enum { CHUNK_STEPS = 64, PIECE_STEPS = 8 };

/*
 * The box of all programmed positions in a chunk or piece, chord errors included, and the largest path tolerance of its
 * steps.
 */
struct batch_chunk {
	axis_values low, high;
	struct position_errors errors;	/* its chord errors are 0 */
	bool beyond;	/* one of its steps is beyond */
	unsigned classes;	/* the classes of its steps, as bits of enum step_class */
};

/* The two sizes of boxes in a batch. */
enum batch_box { BOX_CHUNK, BOX_PIECE };

struct batch {
	struct batch_step *steps;
	size_t step_count, step_capacity;
	struct path_copies paths;
	struct batch_chunk *chunks;	/* chunk i begins with step i * CHUNK_STEPS; the last one may be shorter */
	struct batch_chunk *pieces;	/* the same with PIECE_STEPS */
	size_t chunk_capacity, piece_capacity;
};

void batch_release(struct batch *batch);
void batch_clear(struct batch *batch);

/* Copies a step and its path. */
void batch_add(struct batch *batch, const struct motion_step *step, long block, long number,
	       long share);

/* Fills in chunks and pieces. Call it after the last batch_add, before they are used. */
void batch_close(struct batch *batch);

/* The number of steps in a box of this size; the last box of a batch may have fewer. */
static inline size_t batch_box_steps(enum batch_box size)
{
	return size == BOX_CHUNK ? CHUNK_STEPS : PIECE_STEPS;
}

/* The box of this size that begins with the step; NULL: none does. */
static inline const struct batch_chunk *batch_box_from(const struct batch *batch, enum batch_box size, size_t step)
{
	const size_t steps = batch_box_steps(size);

	return step % steps ? NULL : &(size == BOX_CHUNK ? batch->chunks : batch->pieces)[step / steps];
}

#endif
