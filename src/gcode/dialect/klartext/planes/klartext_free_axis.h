/* klartext_free_axis.h - PLANE with a rotary axis whose angle is arbitrary, because the tool is parallel to it. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_PLANES_KLARTEXT_FREE_AXIS_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_PLANES_KLARTEXT_FREE_AXIS_H

#include <stdbool.h>

#include "gcode/kinematics.h"
#include "gcode/state.h"

/*
 * The position 0 of a rotary axis, degrees as in a slot. If the display of the axis is modulo 360 degrees, it is the
 * nearest of the equivalent positions.
 */
double klartext_free_axis_zero(const struct interp *interp, int slot);

/*
 * The new position of the free axis of this slot, degrees as in a slot, for the plane `tilt`. With COORD ROT (`asked`)
 * the axis stays, or moves to 0 (swivel_pole); with TABLE ROT it turns until the plane's coordinates are parallel to
 * the machine's. Without these words the machine's plane_rotation decides. False: reported, also if it is not known.
 */
bool klartext_free_axis_turn(struct interp *interp, int column, enum plane_rotation asked,
			     const struct kinematics_solution *chosen, const mat3 *tilt, int slot, double *angle);

#endif
