/* pair_measure.h - measures the clearance of one pair in the blocks of each batch. */
#ifndef FIVECHECK_CHECK_PAIR_MEASURE_H
#define FIVECHECK_CHECK_PAIR_MEASURE_H

#include <stdbool.h>

#include "check/pair_check.h"

/* With options->least_clearances: what to measure in a block. Without it every block is measured. */
enum measure_wish {
	MEASURE_NOTHING,	/* report the smallest clearance of all steps so far */
	MEASURE_CURVE,	/* measure a point of the curve, while effort lasts */
	MEASURE_NEAREST	/* measure: the block lowered the smallest clearance of a pair */
};

/* What to measure in a batch. `wishes` and `effort` are used only with options->least_clearances. */
struct measure_plan {
	const double *most;	/* mm, above 0, for the block of each step: the cap of its clearance */
	double largest;	/* mm: the largest initial value in `most` */
	const enum measure_wish *wishes;	/* for the block of each step */
	/* After this number of node pairs curve points are no longer measured, and the nearest blocks only roughly. */
	long effort;
};

/* Is the clearance of this pair measured? Not if the pair may meet in some steps. */
bool pair_measure_applies(const struct pair_check *check);

/*
 * Measures the clearance of the pair in each block of the batch in which it is checked. Returns the number of node
 * pairs examined. If every block is measured, call it before pair_check_run, which then skips the proved steps;
 * otherwise call it after pair_check_run.
 */
long pair_measure(struct pair_check *check, struct sweep *sweep, const struct batch *batch,
		  const struct measure_plan *plan, const struct check_options *options);

#endif
