/* merged_steps.h - several steps of a batch as one chord, which halves into them. */
#ifndef FIVECHECK_CHECK_CERTIFIED_MERGED_STEPS_H
#define FIVECHECK_CHECK_CERTIFIED_MERGED_STEPS_H

#include <stdbool.h>
#include <stddef.h>

#include "check/batch.h"
#include "scene/motion_interval.h"

/* The most steps to a stretch; a power of two, so that halving ends at single steps. */
enum { MERGED_STEPS_MAX = 32 };

/* Can the step be part of a stretch? Not if its way is not known (PATH_BOX). */
bool merged_steps_takes(const struct batch_step *step);

/*
 * The chord from where the first of `count` steps begins to where the last ends;
 * count is a power of two up to MERGED_STEPS_MAX, each step begins where the one before it ends, and
 * the steps outlive the chord. Its deviation holds for the way through all of them, run
 * through at whatever speeds suit the chord: it tells apart from contact, but not when.
 */
struct chord merged_steps_chord(const struct batch_step *steps, size_t count);

#endif
