/* block_clearance.h - a proven lower bound of a pair's distance in each block, up to a cap. */
#ifndef FIVECHECK_CHECK_MEASURE_BLOCK_CLEARANCE_H
#define FIVECHECK_CHECK_MEASURE_BLOCK_CLEARANCE_H

#include <stdbool.h>

#include "check/batch.h"
#include "check/certified/motion_budget.h"
#include "check/measure/measured_step.h"
#include "motion/motion.h"
#include "scene/sweep.h"

/* Only the current block is remembered. */
struct block_clearance {
	struct measured_pair pair;
	struct motion_budget budget;
	int chunks;	/* number of calls of block_clearance_clears */
	double found;	/* mm: two triangles were this close at the start of the budget */
	int unspent;	/* steps since the budget gave the last bound */
	bool maybe_inside;	/* the surfaces have met; since then one body may be inside the other */
};

/* *block must not be moved. */
void block_clearance_init(struct block_clearance *block, const struct body_pair *bodies);

void block_clearance_release(struct block_clearance *block);

/* A new block begins; clearances above `most` (mm, above 0) need not be measured. */
void block_clearance_start(struct block_clearance *block, double most);

/*
 * Is the pair farther apart than `most` (mm) at all positions in the box of this number of steps? thorough: search new
 * planes if that may pay.
 */
bool block_clearance_clears(struct block_clearance *block, const struct batch_chunk *box, double most, size_t steps,
			    bool thorough);

/* mm: an upper estimate of the distance of the bodies at q. */
double block_clearance_look(struct block_clearance *block, struct sweep *sweep, const axis_values *q);

/* Lowers the bound to one that also holds in the step; tolerance (mm) as in sweep_chord. */
void block_clearance_step(struct block_clearance *block, struct sweep *sweep, const struct motion_step *step,
			  double tolerance, enum clearance_accuracy accuracy);

#endif
