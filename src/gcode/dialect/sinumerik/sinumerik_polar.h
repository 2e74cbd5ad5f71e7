/* sinumerik_polar.h - polar coordinates: poles (G110, G111, G112), and ends by RP= and AP=. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_POLAR_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_POLAR_H

#include "gcode/dialect/sinumerik/sinumerik_block.h"

#define SINUMERIK_POLAR_BITS (1U << SINUMERIK_AP | 1U << SINUMERIK_RP)

/* 840D sl, "Polar coordinates". What can fail reports why before it returns false. */

/* G110, G111 or G112 of the block. */
bool sinumerik_polar_set_pole(struct interp *interp, const struct sinumerik_block *block);

/* The pole in force, in program coordinates. */
struct plane_point sinumerik_polar_pole(const struct interp *interp);

/* Puts the end by RP= and AP= into the plane's coordinates of the target. */
bool sinumerik_polar_find(struct interp *interp, const struct sinumerik_block *block, slot_values *target);

#endif
