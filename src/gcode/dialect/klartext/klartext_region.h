/* klartext_region.h - milling cycles of which the region is known in which the tool stays, but not its path. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_REGION_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_REGION_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_parameter.h"

/* Is it one of them: pockets, slots, bores and threads that are milled from within? */
bool klartext_region_is(int number);

/*
 * The tool goes to the set-up clearance, and from there on it may be anywhere in the region, down to the depth, until
 * it stands on the second clearance; where it stands over the region stays open. False: reported, or the sink wants no
 * more.
 */
bool klartext_region_make(const struct klartext_call_of *call);

#endif
