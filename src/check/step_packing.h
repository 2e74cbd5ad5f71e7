/* step_packing.h - steps of a program without what a step repeats of the one before it, and without plain paths. */
#ifndef FIVECHECK_CHECK_STEP_PACKING_H
#define FIVECHECK_CHECK_STEP_PACKING_H

#include <stddef.h>

#include "check/path_copies.h"
#include "motion/events.h"

/* What the packed steps are relative to: the last step. All zero before the first one. */
struct step_packing {
	struct motion_step last;	/* its path is not valid */
	struct path plain;	/* of the last unpacked step, if that is straight and the step is the whole of it */
};

/* The most bytes of a packed step. */
size_t step_packing_most(void);

/*
 * Writes the step to `out`, which is aligned for a double and has room for step_packing_most() bytes, and returns how
 * many were written, a multiple of the size of a double. Paths that are not plain are copied to `paths`, which must
 * outlive the packed step.
 */
size_t step_packing_pack(struct step_packing *packing, const struct motion_step *step, struct path_copies *paths,
			 void *out);

/*
 * Gets the steps back, bit for bit, in the order in which they were packed, with a packing of its own. The arc of a
 * plain path is 0. The step's path is valid until the next step is unpacked, or as long as `paths` keeps it. Returns
 * how many bytes were read.
 */
size_t step_packing_unpack(struct step_packing *packing, const void *packed, struct motion_step *step);

#endif
