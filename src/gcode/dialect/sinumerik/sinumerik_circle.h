/* sinumerik_circle.h - G2, G3 and CIP: by centre, radius, opening angle or an intermediate point, with full turns. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_CIRCLE_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_CIRCLE_H

#include "gcode/dialect/sinumerik/sinumerik_block.h"

struct sinumerik_circle {
	struct canon_arc arc;	/* of the controller's positions */
	bool in_plane;	/* G2 or G3, and then: */
	struct plane_point centre;	/* straight (rotated_frame.h) */
	int turns;	/* from 1 */
};

/*
 * The arc from the present position to the target, in program coordinates, which AR= with a centre changes. False:
 * reported.
 */
bool sinumerik_circle_find(struct interp *interp, const struct sinumerik_block *block, slot_values *target,
			   struct sinumerik_circle *found);

#endif
