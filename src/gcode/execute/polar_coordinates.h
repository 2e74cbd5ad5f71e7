/* polar_coordinates.h - G15 and G16: the two words of the plane are a radius and an angle. */
#ifndef FIVECHECK_GCODE_EXECUTE_POLAR_COORDINATES_H
#define FIVECHECK_GCODE_EXECUTE_POLAR_COORDINATES_H

#include <stdbool.h>

#include "gcode/state.h"

/* Fanuc B-64484EN, "Polar Coordinate Command (G15, G16)". Functions that can fail report the reason first. */

/* Carries out the block's G15 or G16, if it has one. */
bool polar_coordinates_switch(struct interp *interp);

/* Is G16 active, and is this axis in its plane? Then the axis' word is no coordinate. */
bool polar_coordinates_take(const struct interp *interp, int slot);

/* Is the word of this axis the angle? */
bool polar_coordinates_is_angle(const struct interp *interp, char letter);

/* Sets the target to the straight position of the block's radius and angle; an incremental angle adds to the last. */
bool polar_coordinates_find(struct interp *interp, slot_values *target);

#endif
