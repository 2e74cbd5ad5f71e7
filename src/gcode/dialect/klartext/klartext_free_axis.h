/* klartext_free_axis.h - PLANE and a rotary axis that any angle suits, because the tool lies along it. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_FREE_AXIS_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_FREE_AXIS_H

#include <stdbool.h>

#include "gcode/kinematics.h"
#include "gcode/state.h"

/*
 * The 0 of a rotary axis, degrees as in a slot: a whole turn away is the same one where the display is reduced, and the
 * one that is nearest counts.
 */
double klartext_free_axis_zero(const struct interp *interp, int slot);

/*
 * Where the free axis of this slot goes, degrees as in a slot, for the plane `tilt`. COORD ROT (`asked`) leaves the
 * axis where it is, or takes it to 0 (swivel_pole); TABLE ROT turns it until the plane's coordinates lie along the
 * machine's. Without either word the machine's plane_rotation counts. False: reported, also where nobody has said it.
 */
bool klartext_free_axis_turn(struct interp *interp, int column, enum plane_rotation asked,
			     const struct kinematics_solution *chosen, const mat3 *tilt, int slot, double *angle);

#endif
