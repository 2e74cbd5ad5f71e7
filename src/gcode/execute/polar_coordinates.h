/* polar_coordinates.h - a radius and an angle in place of two coordinates: G15 and G16; @ and ^ of LinuxCNC. */
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

/*
 * LinuxCNC's manual, "Polar Coordinates": @ is the distance from X0 Y0 and ^ the angle from X, in the plane of X and Y;
 * one of them alone leaves the other as it is. With G91 both count from the position of the tool. Sets the straight
 * position of X and Y for the block's @ and ^.
 */
bool polar_coordinates_words(struct interp *interp, slot_values *target);

#endif
