/* polar_coordinates.h - G16: the two words of the plane are a radius and an angle. */
#ifndef FIVECHECK_GCODE_EXECUTE_POLAR_COORDINATES_H
#define FIVECHECK_GCODE_EXECUTE_POLAR_COORDINATES_H

#include <stdbool.h>

#include "gcode/state.h"

/* Fanuc B-64484EN, "Polar Coordinate Command (G15, G16)". What can fail reports why before it returns false. */

/* Carries out the block's G15 or G16, if it has one. */
bool polar_coordinates_switch(struct interp *interp);

/* Is G16 in force, and is this axis in its plane? Then its word is no coordinate. */
bool polar_coordinates_take(const struct interp *interp, int slot);

/* Is this axis' word the angle? */
bool polar_coordinates_is_angle(const struct interp *interp, char letter);

/* Puts the straight position that the block's radius and angle mean into the target; an increment turns farther. */
bool polar_coordinates_find(struct interp *interp, slot_values *target);

#endif
