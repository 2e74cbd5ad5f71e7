/* block_clearance.h - a proven lower bound of a pair's distance in each block, as far as it is of interest. */
#ifndef FIVECHECK_CHECK_MEASURE_BLOCK_CLEARANCE_H
#define FIVECHECK_CHECK_MEASURE_BLOCK_CLEARANCE_H

#include <stdbool.h>
#include <stdint.h>

#include "check/batch.h"
#include "check/certified/motion_budget.h"
#include "check/certified/plane_account.h"
#include "check/certified/plane_cells.h"
#include "check/measure/clearance_accuracy.h"
#include "motion/motion.h"
#include "scene/coherence.h"
#include "scene/sweep.h"

enum { SEEN_KEPT = 3 };

/* How far apart two triangles are at a position. */
struct seen_distance {
	bool known;
	axis_values q;
	uint32_t triangles[2];	/* of A, B */
	double distance;	/* mm */
};

/* The pose of two bodies (body_pair_pose) at a position. */
struct posed {
	bool known;
	axis_values q;
	xform pose;
};

/* Only the block under way is remembered. */
struct block_clearance {
	struct body_pair bodies;
	struct coherence coherence;
	struct motion_budget budget;
	struct plane_cells planes;
	struct plane_account account;	/* of searches for planes */
	int chunks;	/* that block_clearance_clears was asked for */
	double found;	/* mm: where the budget begins, two triangles were this close */
	int unspent;	/* steps since the budget gave the last bound */
	struct posed posed;	/* where triangles were looked at last */
	struct seen_distance seen[SEEN_KEPT];	/* the last ones, as the next step begins where one ends */
	int oldest_seen;
	bool by_parts;	/* planes between the whole bodies were of no use when planes were last carried on */
	bool is_near;	/* the last step had less than what was of interest */
	enum clearance_accuracy accuracy;	/* of the step under way */
	double bound;	/* mm: proven for the block so far: more than this, or at least `most`; 0: nothing */
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
