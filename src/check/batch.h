/* batch.h - some thousand steps of a program with all that is needed to check them later, pair by pair. */
#ifndef FIVECHECK_CHECK_BATCH_H
#define FIVECHECK_CHECK_BATCH_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "check/budget.h"
#include "motion/motion.h"
#include "motion/tcp.h"

/* Where a step stands: `block` numbers the program's blocks from 0. */
struct batch_step {
	struct motion_step motion;	/* its path is the batch's once it is settled */
	size_t path;	/* index into paths */
	long block;
	bool beyond;	/* past a limit, or near enough for the path tolerance: nothing is out of reach */
};

/* Steps to a chunk. */
enum { CHUNK_STEPS = 64 };

/* All positions that the axes are told to take in a chunk, chord errors included; the most path tolerance besides. */
struct batch_chunk {
	axis_values low, high;
	struct position_errors errors;	/* its chord errors are 0 */
	bool beyond;	/* one of its steps is */
};

struct batch {
	struct batch_step *steps;
	size_t step_count, step_capacity;
	struct path *paths;
	size_t path_count, path_capacity;
	size_t *path_tcp;	/* of each path: index into tcps */
	size_t path_tcp_capacity;
	struct tcp *tcps;
	size_t tcp_count, tcp_capacity;
	struct batch_chunk *chunks;	/* chunk i: the CHUNK_STEPS steps, or what is left, from i * CHUNK_STEPS on */
	size_t chunk_capacity;
};

void batch_release(struct batch *batch);
void batch_clear(struct batch *batch);

/* Copies a step and, if it is curved, its path. */
void batch_add(struct batch *batch, const struct motion_step *step, long block);

/* Points the steps to the batch's own paths; call it before using them. */
void batch_settle(struct batch *batch);

/* The same, and sums up the chunks. */
void batch_close(struct batch *batch);

#endif
