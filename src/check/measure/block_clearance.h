/* block_clearance.h - a proven lower bound of a pair's distance in each block, as far as it is of interest. */
#ifndef FIVECHECK_CHECK_MEASURE_BLOCK_CLEARANCE_H
#define FIVECHECK_CHECK_MEASURE_BLOCK_CLEARANCE_H

#include <stdbool.h>

#include "check/batch.h"
#include "check/certified/motion_budget.h"
#include "check/measure/measured_step.h"
#include "motion/motion.h"
#include "scene/sweep.h"

/* Only the block under way is remembered. */
struct block_clearance {
	struct measured_pair pair;
	struct motion_budget budget;
	int chunks;	/* that block_clearance_clears was asked for */
	double found;	/* mm: where the budget begins, two triangles were this close */
	int unspent;	/* steps since the budget gave the last bound */
	bool maybe_inside;	/* the surfaces have met; since then one body may be inside the other */
};

/* The block must stay where it is from here on. */
void block_clearance_init(struct block_clearance *block, const struct body_pair *bodies);

void block_clearance_release(struct block_clearance *block);

/* A new block begins, in which a larger clearance than `most` (mm, above 0) is of no interest. */
void block_clearance_start(struct block_clearance *block, double most);

/*
 * Is the pair farther apart than `most` (mm) at all positions in the box of so many steps? thorough: new planes are
 * searched if that may pay.
 */
bool block_clearance_clears(struct block_clearance *block, const struct batch_chunk *box, double most, size_t steps,
			    bool thorough);

/* mm: roughly how far apart the bodies are at q: not less than they are. */
double block_clearance_look(struct block_clearance *block, struct sweep *sweep, const axis_values *q);

/* Lowers the bound to what holds in the step, too; tolerance (mm) as in sweep_chord. */
void block_clearance_step(struct block_clearance *block, struct sweep *sweep, const struct motion_step *step,
			  double tolerance, enum clearance_accuracy accuracy);

#endif
