/* polar_interpolation.h - polar coordinate interpolation: G12.1 and G13.1 of Fanuc. */
#ifndef FIVECHECK_GCODE_EXECUTE_POLAR_INTERPOLATION_H
#define FIVECHECK_GCODE_EXECUTE_POLAR_INTERPOLATION_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Fanuc 15i operator's manual (B-63324EN) and 30i-B (B-64484EN), "Polar Coordinate Interpolation": from G12.1 on, X and
 * the word of the rotary axis are a point of a plane, both lengths, about the zero of X. X goes to its distance from
 * there, and the rotary axis to its angle, counted from where it stands at G12.1; there the point is (X, 0). While it
 * is on, the position of Y in the state is the second coordinate of the plane, and the rotary axis stays where it was
 * at G12.1; polar_pieces.h makes moves of the axes of it.
 */

/* Carries out G12.1 or G13.1. False: reported. */
bool polar_interpolation_switch(struct interp *interp);

/* Refuses what the manual does not allow, and makes a word of Y of the rotary axis' word. False: reported. */
bool polar_interpolation_start_block(struct interp *interp);

#endif
