/* step.h - one step of a program as a pair of bodies sees it: what it moves, and how far it may be off its line. */
#ifndef FIVECHECK_CHECK_STEP_H
#define FIVECHECK_CHECK_STEP_H

#include <stdbool.h>

#include "machine/chain.h"
#include "motion/motion.h"

/* By how much each axis may be away from where it is said to be: mm, radians. */
struct position_errors {
	axis_values chord;	/* chord error: the programmed path is so far from the straight line */
	axis_values path;	/* path tolerance: the control may be so far from the programmed path */
	bool any;	/* false: all of them are 0 */
};

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

#endif
