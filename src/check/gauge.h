/* gauge.h - how near a pair of bodies comes in each block: a proven bound on its distance, up to a cap. */
#ifndef FIVECHECK_CHECK_GAUGE_H
#define FIVECHECK_CHECK_GAUGE_H

#include <stdbool.h>

#include "check/budget.h"
#include "motion/motion.h"
#include "scene/coherence.h"
#include "scene/sweep.h"

/*
 * What is proven is at least this share of the smallest distance in the block, or of the cap, less the
 * tolerance; where the way of a rapid is not known (PATH_BOX) it may be any lower bound.
 */
#define GAUGE_SHARE 0.85

/* Only the block under way is remembered. */
struct gauge {
	struct body_pair bodies;
	struct coherence coherence;
	struct budget budget;
	double found;	/* mm: two triangles were this close where the budget begins */
	double cap;	/* mm */
	double bound;	/* mm: more than this, or the whole cap, is proven for the block so far; 0: nothing */
	bool entangled;	/* surfaces have met, and may have parted with one body inside the other */
};

/* The gauge must stay where it is from here on. */
void gauge_init(struct gauge *gauge, const struct body_pair *bodies, double cap);

/* A new block begins. */
void gauge_start(struct gauge *gauge);

/* Is the pair, wherever between low and high the axes stand, farther apart than the cap? */
bool gauge_clears(const struct gauge *gauge, const axis_values *low, const axis_values *high,
		  const struct position_errors *errors);

/* Lowers the bound to what holds in the step, too; tolerance (mm) as in sweep_chord. */
void gauge_step(struct gauge *gauge, struct sweep *sweep, const struct motion_step *step, double tolerance);

#endif
