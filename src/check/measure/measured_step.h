/* measured_step.h - measures the smallest distance of two bodies in a step, with travelling planes. */
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

/* The state that is kept from step to step. It must not be moved. */
struct measured_pair {
	struct body_pair bodies;
	struct coherence coherence;
	struct plane_cells planes;
	struct plane_account account;	/* of the plane searches */
	struct posed posed;	/* the pose of the last distance of triangles */
	struct seen_distance seen[SEEN_KEPT];	/* the last ones, because the next step begins where this one ends */
	int oldest_seen;
	bool by_parts;	/* planes between the whole bodies failed when planes were last carried on */
	bool is_near;	/* in the last step the clearance was below the cap */
	enum clearance_accuracy accuracy;	/* of the current step */
	double bound;	/* mm: the clearance of the block so far is proven to be more than this; 0: nothing */
};

void measured_pair_init(struct measured_pair *pair, const struct body_pair *bodies);
void measured_pair_release(struct measured_pair *pair);

/* A step whose smallest distance is measured. */
struct measured_step {
	const struct motion_step *step;
	struct position_errors errors;
	double path;	/* mm: no path displacement is larger */
	double seen;	/* mm: two triangles are this close somewhere on the step: an upper bound */
	double wanted;	/* mm: the gap that planes must prove, from the present upper bound */
	double rest;	/* mm: proved by the budget */
};

void measured_step_init(struct measured_step *measured, const struct measured_pair *pair,
			const struct motion_step *step);

/*
 * Do travelling planes prove as much for the step as the pair has so far, or nearly the true distance? Then they set
 * the bound. Adds the examined node pairs to those of the sweep.
 */
bool measured_step_by_planes(struct measured_step *measured, struct measured_pair *pair, struct sweep *sweep);

#endif
