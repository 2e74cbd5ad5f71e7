/* motion_modes.h - the modes of a move besides its path; only reports use them. */
#ifndef FIVECHECK_MOTION_MOTION_MODES_H
#define FIVECHECK_MOTION_MOTION_MODES_H

#include <stdbool.h>

#include "gcode/canon.h"
#include "motion/events.h"

/* The modes of a move, which is a rapid, a feed, or an arc. */
struct motion_modes motion_modes_of(const struct canon_move *move);

bool motion_modes_same(const struct motion_modes *a, const struct motion_modes *b);

#endif
