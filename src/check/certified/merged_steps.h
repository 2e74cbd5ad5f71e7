/* merged_steps.h - several steps of a batch as one chord, which can be halved into the steps again. */
#ifndef FIVECHECK_CHECK_CERTIFIED_MERGED_STEPS_H
#define FIVECHECK_CHECK_CERTIFIED_MERGED_STEPS_H

#include <stdbool.h>
#include <stddef.h>

#include "check/batch.h"
#include "scene/motion_interval.h"

/* The most steps that are merged; a power of two, so that halving ends at single steps. */
enum { MERGED_STEPS_MAX = 32 };

/* Can the step be merged with others? A step whose path is not known (PATH_BOX) cannot. */
bool merged_steps_takes(const struct batch_step *step);

/*
 * The chord from the start of the first of `count` steps to the end of the last; count is a power of two up to
 * MERGED_STEPS_MAX, each step begins at the end of the one before, and the steps outlive the chord. Its deviation holds
 * for the path through all steps at speeds that fit the chord, not at the programmed ones. So a sweep of the chord
 * shows whether the bodies meet, but not when. The chord has no path tolerance yet.
 */
struct chord merged_steps_chord(const struct batch_step *steps, size_t count);

/* The largest path tolerance of the chord's steps, stored in *most; NULL: no step has one. */
const axis_values *merged_steps_tolerance(const struct chain *chain, const struct chord *merged, axis_values *most);

#endif
