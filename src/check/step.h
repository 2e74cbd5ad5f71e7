/* step.h - one step of a program as a pair of bodies sees it: what it moves, how far it may stray, a sweep along it. */
#ifndef FIVECHECK_CHECK_STEP_H
#define FIVECHECK_CHECK_STEP_H

#include <stdbool.h>

#include "check/certified/motion_budget.h"
#include "motion/motion.h"
#include "scene/sweep.h"

/* Does any joint of the chain move, the path's own chord error included? */
bool step_moves(const struct chain *chain, const struct motion_step *step);

/* May the control leave the path of any joint of the chain (G64)? */
bool step_may_stray(const struct chain *chain, const struct motion_step *step);

/* What the joints of the chain may be off the straight line between the step's ends. */
struct position_errors step_errors(const struct chain *chain, const struct motion_step *step);

/* Is the way between the ends not known (PATH_BOX)? */
bool step_is_box(const struct motion_step *step);

/* All positions between the step's ends, axis by axis, without errors. */
void step_box(const struct motion_step *step, axis_values *low, axis_values *high);

/* What is asked of a step: do the bodies stay farther apart than the clearance? Borrows everything. */
struct clearance_query {
	struct sweep *sweep;
	const struct body_pair *bodies;
	double clearance, tolerance;	/* mm, as in sweep_chord */
	bool any;	/* any contact will do, not just the first */
	long box_visits;	/* node pairs to look at for a step whose way is not known; 0: no limit */
};

enum sweep_answer chord_sweep(const struct clearance_query *query, const struct chord *chord, struct contact *contact);

/* The same along a step, with the path tolerance that it has. */
enum sweep_answer step_sweep(const struct clearance_query *query, const struct motion_step *step, struct contact *contact);

#endif
