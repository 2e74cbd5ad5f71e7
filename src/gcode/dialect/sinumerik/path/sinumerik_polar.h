/* sinumerik_polar.h - polar coordinates: poles (G110, G111, G112), end points by RP= and AP=, lines by ANG=. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_POLAR_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_POLAR_H

#include "gcode/dialect/sinumerik/block/sinumerik_block.h"

#define SINUMERIK_POLAR_BITS (1U << SINUMERIK_AP | 1U << SINUMERIK_RP)
#define SINUMERIK_LINE_BIT (1U << SINUMERIK_ANG)

/* 840D sl, "Polar coordinates". A function that can fail reports the reason and returns false. */

/* Executes G110, G111 or G112 of the block. */
bool sinumerik_polar_set_pole(struct interp *interp, const struct sinumerik_block *block);

/* The active pole, in program coordinates. */
struct plane_point sinumerik_polar_pole(const struct interp *interp);

/* Puts the end point by RP= and AP= into the plane's coordinates of the target. */
bool sinumerik_polar_find(struct interp *interp, const struct sinumerik_block *block, slot_values *target);

/*
 * Computes the coordinate that ANG= replaces; the target has the other coordinate of the plane ("Contour definition",
 * one straight line). ANG is relative to the first axis of the plane. `shifted`: offsets have changed since the axes
 * of the plane were programmed.
 */
bool sinumerik_polar_find_line(struct interp *interp, const struct sinumerik_block *block, bool shifted,
			       slot_values *target);

/* Have offsets changed since the axes of the plane were programmed? */
bool sinumerik_polar_is_shifted(const struct interp *interp);

#endif
