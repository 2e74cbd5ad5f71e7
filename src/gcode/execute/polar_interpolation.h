/* polar_interpolation.h - polar coordinate interpolation: G12.1 and G13.1 of Fanuc. */
#ifndef FIVECHECK_GCODE_EXECUTE_POLAR_INTERPOLATION_H
#define FIVECHECK_GCODE_EXECUTE_POLAR_INTERPOLATION_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Fanuc 15i operator's manual (B-63324EN) and 30i-B (B-64484EN), "Polar Coordinate Interpolation": after G12.1, X and
 * the word of the rotary axis are the coordinates of a point in a plane, both lengths, with the centre at the zero of
 * X. X moves to the point's distance from the centre, and the rotary axis to the point's angle, measured from its
 * position at G12.1, where the point is (X, 0). While G12.1 is active, the state has the second coordinate of the plane
 * as the position of Y, and the rotary axis keeps its position at G12.1 in the state; polar_pieces.h computes the moves
 * of the axes.
 */

/* Carries out G12.1 or G13.1. False: reported. */
bool polar_interpolation_switch(struct interp *interp);

/* Refuses what the manual does not allow, and replaces the rotary axis' word by a word of Y. False: reported. */
bool polar_interpolation_start_block(struct interp *interp);

#endif
