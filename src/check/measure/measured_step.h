/* measured_step.h - the smallest distance of two bodies in a step, as travelling planes prove it. */
#ifndef FIVECHECK_CHECK_MEASURE_MEASURED_STEP_H
#define FIVECHECK_CHECK_MEASURE_MEASURED_STEP_H

#include <stdbool.h>

#include "check/measure/block_clearance.h"

/* A step whose smallest distance is looked for. */
struct measured_step {
	const struct motion_step *step;
	struct position_errors errors;
	double path;	/* mm: no path displacement is larger */
	double seen;	/* mm: two triangles were this close somewhere on it: the bodies are no farther apart */
	double rest;	/* mm: what the budget proves */
};

void measured_step_init(struct measured_step *measured, const struct block_clearance *block,
			const struct motion_step *step);

/*
 * Do travelling planes prove as much for the step as the block has, or nearly all there is? They give the bound. Adds
 * the node pairs that it looks at to the sweep's.
 */
bool measured_step_by_planes(struct measured_step *measured, struct block_clearance *block, struct sweep *sweep);

#endif
