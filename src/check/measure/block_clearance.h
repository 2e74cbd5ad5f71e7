/* block_clearance.h - how near a pair of bodies comes in each block: a proven bound on its distance, up to a cap. */
#ifndef FIVECHECK_CHECK_MEASURE_BLOCK_CLEARANCE_H
#define FIVECHECK_CHECK_MEASURE_BLOCK_CLEARANCE_H

#include <stdbool.h>

#include "check/certified/motion_budget.h"
#include "motion/motion.h"
#include "scene/coherence.h"
#include "scene/sweep.h"

/*
 * What is proven is at least this share of the smallest distance in the block, or of the cap, less the
 * tolerance; where the way of a rapid is not known (PATH_BOX) it may be any lower bound.
 */
#define BLOCK_CLEARANCE_SHARE 0.85

/* Only the block under way is remembered. */
struct block_clearance {
	struct body_pair bodies;
	struct coherence coherence;
	struct motion_budget budget;
	double found;	/* mm: two triangles were this close where the budget begins */
	double cap;	/* mm */
	double bound;	/* mm: more than this, or the whole cap, is proven for the block so far; 0: nothing */
	bool maybe_inside;	/* surfaces have met, and may have parted with one body inside the other */
};

/* The block must stay where it is from here on. */
void block_clearance_init(struct block_clearance *block, const struct body_pair *bodies, double cap);

/* A new block begins. */
void block_clearance_start(struct block_clearance *block);

/* Is the pair, wherever between low and high the axes stand, farther apart than the cap? */
bool block_clearance_clears(const struct block_clearance *block, const axis_values *low, const axis_values *high,
		  const struct position_errors *errors);

/* Lowers the bound to what holds in the step, too; tolerance (mm) as in sweep_chord. */
void block_clearance_step(struct block_clearance *block, struct sweep *sweep, const struct motion_step *step, double tolerance);

#endif
