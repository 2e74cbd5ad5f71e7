/* sinumerik_circle.h - G2, G3 and CIP: by centre, radius, opening angle or an intermediate point, with full turns. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_CIRCLE_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_CIRCLE_H

#include "gcode/dialect/sinumerik/block/sinumerik_block.h"

struct sinumerik_circle {
	struct canon_arc arc;	/* of the controller's positions */
	bool straight;	/* CT to a point ahead: no arc */
	bool in_plane;	/* G2, G3 or CT, and then: */
	bool clockwise;
	struct plane_point centre;	/* straight (rotated_frame.h) */
	int turns;	/* from 1 */
};

/*
 * The arc from the present position to the target, in program coordinates, which AR= with a centre changes. False:
 * reported.
 */
bool sinumerik_circle_find(struct interp *interp, const struct sinumerik_block *block, slot_values *target,
			   struct sinumerik_circle *found);

/*
 * Keeps, for CT, the direction at the end of a motion between two places in program coordinates. With a null circle
 * the motion is straight.
 */
void sinumerik_circle_keep_tangent(struct interp *interp, const slot_values *from, const slot_values *to,
				   const struct sinumerik_circle *circle);

#endif
