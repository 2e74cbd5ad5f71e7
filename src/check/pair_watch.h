/* pair_watch.h - when a pair is checked: with which tool in the spindle, and in which steps. */
#ifndef FIVECHECK_CHECK_PAIR_WATCH_H
#define FIVECHECK_CHECK_PAIR_WATCH_H

#include <stdbool.h>

#include "check/batch.h"

struct pair_watch {
	int tool;	/* the tool that one of the bodies belongs to; 0: none */
	unsigned steps;	/* bits of enum step_class: the classes in which it is checked */
	bool past_limits_only;	/* out of reach as long as no axis leaves its travel */
	long left_block;	/* the last block that had a finding of this pair or was not decided; -1: none */
};

/* Is the pair present while this tool is in the spindle? */
static inline bool pair_watch_is_active(const struct pair_watch *watch, int tool)
{
	return !watch->tool || watch->tool == tool;
}

/* Must the pair stay apart in this step? */
static inline bool pair_watch_has(const struct pair_watch *watch, const struct batch_step *step)
{
	return (watch->steps & (unsigned)step->motion.step_class) != 0 && (!watch->past_limits_only || step->beyond);
}

/* Must it stay apart in any step of the box? */
static inline bool pair_watch_has_any(const struct pair_watch *watch, const struct batch_chunk *box)
{
	return (watch->steps & box->classes) != 0 && (!watch->past_limits_only || box->beyond);
}

#endif
