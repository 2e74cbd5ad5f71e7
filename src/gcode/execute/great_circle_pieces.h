/*
 * great_circle_pieces.h - moves under TCP that turn the tool in the plane of its two directions, divided into pieces
 * that are short enough for linear interpolation of the rotary axes with a small deviation.
 */
#ifndef FIVECHECK_GCODE_EXECUTE_GREAT_CIRCLE_PIECES_H
#define FIVECHECK_GCODE_EXECUTE_GREAT_CIRCLE_PIECES_H

#include <stdbool.h>

#include "gcode/state.h"

/* Radians: tolerance for equal directions, and for equal rotary positions at the end of a move. */
#define GREAT_CIRCLE_SAME_DIRECTION 1e-9
#define GREAT_CIRCLE_SAME_END 1e-6

/*
 * Finds the great circle from the present direction of the tool to a direction (a unit vector, as in
 * kinematics_orientation); NULL: to the direction of the rotary positions `last`. *angle is the angle between the two
 * directions. False: reported.
 */
bool great_circle_pieces_find(struct interp *interp, int column, const axis_values *last, const vec3 *direction,
			      struct kinematics_great_circle *way, double *angle);

/*
 * *can: the whole great circle can be followed. It cannot if it comes so near to a pole that an axis would have to turn
 * infinitely fast. False: reported.
 */
bool great_circle_pieces_try(struct interp *interp, int column, const struct kinematics_great_circle *way, bool *can);

/* Calls `go` for each piece of the great circle; `rotary` is then at s1. False: reported, or `go` returned false. */
typedef bool (*great_circle_pieces_fn)(void *context, const struct kinematics_great_circle *piece);
bool great_circle_pieces_go(struct interp *interp, int column, const struct kinematics_great_circle *way,
			    great_circle_pieces_fn go, void *context);

#endif
