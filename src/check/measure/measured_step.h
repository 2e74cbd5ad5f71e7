/* measured_step.h - the smallest distance of two bodies in a step, as travelling planes prove it. */
#ifndef FIVECHECK_CHECK_MEASURE_MEASURED_STEP_H
#define FIVECHECK_CHECK_MEASURE_MEASURED_STEP_H

#include <stdbool.h>
#include <stdint.h>

#include "check/certified/plane_account.h"
#include "check/certified/plane_cells.h"
#include "check/measure/clearance_accuracy.h"
#include "check/step.h"
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

/* What is remembered from step to step. It must stay where it is. */
struct measured_pair {
	struct body_pair bodies;
	struct coherence coherence;
	struct plane_cells planes;
	struct plane_account account;	/* of searches for planes */
	struct posed posed;	/* where triangles were looked at last */
	struct seen_distance seen[SEEN_KEPT];	/* the last ones, as the next step begins where one ends */
	int oldest_seen;
	bool by_parts;	/* planes between the whole bodies were of no use when planes were last carried on */
	bool is_near;	/* the last step had less than what was of interest */
	enum clearance_accuracy accuracy;	/* of the step under way */
	double bound;	/* mm: proven for the block so far: more than this, or all that is of interest; 0: nothing */
};

void measured_pair_init(struct measured_pair *pair, const struct body_pair *bodies);
void measured_pair_release(struct measured_pair *pair);

/* A step whose smallest distance is looked for. */
struct measured_step {
	const struct motion_step *step;
	struct position_errors errors;
	double path;	/* mm: no path displacement is larger */
	double seen;	/* mm: two triangles were this close somewhere on it: the bodies are no farther apart */
	double wanted;	/* mm: what is wanted of planes, as far as it is known how near the bodies come */
	double rest;	/* mm: what the budget proves */
};

void measured_step_init(struct measured_step *measured, const struct measured_pair *pair,
			const struct motion_step *step);

/*
 * Do travelling planes prove as much for the step as the pair has, or nearly all there is? They give the bound. Adds
 * the node pairs that it looks at to the sweep's.
 */
bool measured_step_by_planes(struct measured_step *measured, struct measured_pair *pair, struct sweep *sweep);

#endif
