/* klartext_swivel_free.h - PLANE and a rotary axis that any angle suits, because the tool lies along it. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_SWIVEL_FREE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_SWIVEL_FREE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_swivel.h"

/*
 * Where the free axis of this slot goes, degrees as in a slot, for the plane `tilt`. COORD ROT leaves the axis where it
 * is, or takes it to 0 (swivel_pole); TABLE ROT turns it until the plane's coordinates lie along the machine's. Without
 * either word the machine's plane_rotation counts. False: reported, also where nobody has said it.
 */
bool klartext_swivel_free_turn(struct interp *interp, const struct klartext_swivel *request,
			       const struct kinematics_solution *chosen, const mat3 *tilt, int slot, double *angle);

#endif
