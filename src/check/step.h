/* step.h - one step of a program as it moves one pair of bodies, and how far the axes may be from its straight line. */
#ifndef FIVECHECK_CHECK_STEP_H
#define FIVECHECK_CHECK_STEP_H

#include <stdbool.h>

#include "machine/chain.h"
#include "motion/motion.h"

/* How far each axis may be from its nominal position: mm, radians. */
struct position_errors {
	axis_values chord;	/* chord error: how far the programmed path may be from the straight line */
	axis_values path;	/* path tolerance: how far the control may leave the programmed path */
	bool any;	/* false: all of them are 0 */
};

/* Does any joint of the chain move? A chord error above 0 counts as motion. */
bool step_moves(const struct chain *chain, const struct motion_step *step);

/* May the control leave the path of any joint of the chain (G64)? */
bool step_may_leave_path(const struct chain *chain, const struct motion_step *step);

/* The errors of the chain's joints in the step. */
struct position_errors step_errors(const struct chain *chain, const struct motion_step *step);

/* Is the path between the step's ends unknown (PATH_BOX)? */
bool step_is_box(const struct motion_step *step);

/* The box of all positions between the step's ends, without errors. */
void step_box(const struct motion_step *step, axis_values *low, axis_values *high);

#endif
