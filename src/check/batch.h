/* batch.h - copies of some thousand steps of a program, which are then checked pair by pair. */
#ifndef FIVECHECK_CHECK_BATCH_H
#define FIVECHECK_CHECK_BATCH_H

#include <stdbool.h>
#include <stddef.h>

#include "check/path_copies.h"
#include "check/step.h"
#include "motion/events.h"

/* Where a step stands: `block` numbers the program's blocks from 0. */
struct batch_step {
	struct motion_step motion;	/* its path is the batch's copy */
	long block;
	bool beyond;	/* past a limit, or near enough for the path tolerance: nothing is out of reach */
};

/* Steps to a chunk. */
enum { CHUNK_STEPS = 64 };

/* All programmed positions of the axes in a chunk, chord errors included, and its largest path tolerance. */
struct batch_chunk {
	axis_values low, high;
	struct position_errors errors;	/* its chord errors are 0 */
	bool beyond;	/* one of its steps is */
	unsigned classes;	/* bits of enum step_class: of its steps */
};

struct batch {
	struct batch_step *steps;
	size_t step_count, step_capacity;
	struct path_copies paths;
	struct batch_chunk *chunks;	/* chunk i: the CHUNK_STEPS steps, or what is left, from i * CHUNK_STEPS on */
	size_t chunk_capacity;
};

void batch_release(struct batch *batch);
void batch_clear(struct batch *batch);

/* Copies a step and its path. */
void batch_add(struct batch *batch, const struct motion_step *step, long block);

/* Sums up the chunks; call it before using them. */
void batch_close(struct batch *batch);

#endif
