/* sinumerik_circle.h - G2, G3 and CIP: by centre, radius, opening angle or an intermediate point, with full turns. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_CIRCLE_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_CIRCLE_H

#include "gcode/dialect/sinumerik/sinumerik_block.h"

/*
 * The arc from the present position to the target, in program coordinates, which AR= with a centre changes. *arc is
 * that of the controller's positions. False: reported.
 */
bool sinumerik_circle_find(struct interp *interp, const struct sinumerik_block *block, slot_values *target,
			   struct canon_arc *arc);

#endif
