/* block_clearance.h - a proven lower bound of a pair's distance in each block, up to a cap. */
#ifndef FIVECHECK_CHECK_MEASURE_BLOCK_CLEARANCE_H
#define FIVECHECK_CHECK_MEASURE_BLOCK_CLEARANCE_H

#include <stdbool.h>

#include "check/certified/motion_budget.h"
#include "check/certified/plane_account.h"
#include "check/certified/plane_cells.h"
#include "motion/motion.h"
#include "scene/coherence.h"
#include "scene/sweep.h"

/*
 * The bound is at least this share of the smallest distance in the block, or of the cap, less the tolerance. Where the
 * way of a rapid is not known (PATH_BOX) it may be any lower bound.
 */
#define BLOCK_CLEARANCE_SHARE 0.85

/* Only the block under way is remembered. */
struct block_clearance {
	struct body_pair bodies;
	struct coherence coherence;
	struct motion_budget budget;
	struct plane_cells planes;
	struct plane_account account;	/* of searches for planes */
	double found;	/* mm: where the budget begins, two triangles were this close */
	double cap;	/* mm */
	double bound;	/* mm: proven for the block so far: more than this, or at least the cap; 0: nothing */
	bool maybe_inside;	/* the surfaces have met; since then one body may be inside the other */
};

/* The block must stay where it is from here on. */
void block_clearance_init(struct block_clearance *block, const struct body_pair *bodies, double cap);

void block_clearance_release(struct block_clearance *block);

/* A new block begins. */
void block_clearance_start(struct block_clearance *block);

/* Is the pair farther apart than the cap at all positions between low and high, which so many steps have? */
bool block_clearance_clears(struct block_clearance *block, const axis_values *low, const axis_values *high,
		  const struct position_errors *errors, size_t steps);

/* Lowers the bound to what holds in the step, too; tolerance (mm) as in sweep_chord. */
void block_clearance_step(struct block_clearance *block, struct sweep *sweep, const struct motion_step *step,
			  double tolerance);

#endif
