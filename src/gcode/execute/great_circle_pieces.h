/*
 * great_circle_pieces.h - moves under TCP whose tool turns in the plane of its two directions, in pieces along each of
 * which the rotary axes are straight but for a little.
 */
#ifndef FIVECHECK_GCODE_EXECUTE_GREAT_CIRCLE_PIECES_H
#define FIVECHECK_GCODE_EXECUTE_GREAT_CIRCLE_PIECES_H

#include <stdbool.h>

#include "gcode/state.h"

/* Radians: two directions, and two rotary positions at the end of a way, that count as the same. */
#define GREAT_CIRCLE_SAME_DIRECTION 1e-9
#define GREAT_CIRCLE_SAME_END 1e-6

/*
 * The way from where the axes are to a direction (a unit vector, as in kinematics_orientation); NULL: to the one to
 * which the rotary positions `last` turn the tool. *angle is that between the two. False: reported.
 */
bool great_circle_pieces_find(struct interp *interp, int column, const axis_values *last, const vec3 *direction,
			      struct kinematics_great_circle *way, double *angle);

/*
 * Can the whole way be followed? Not where it comes so near to a pole that an axis would have to turn infinitely fast.
 * False: reported.
 */
bool great_circle_pieces_try(struct interp *interp, int column, const struct kinematics_great_circle *way, bool *can);

/* Calls `go` for each piece of a way that can be followed; `rotary` is at s1 then. False: reported, or it was false. */
typedef bool (*great_circle_pieces_fn)(void *context, const struct kinematics_great_circle *piece);
bool great_circle_pieces_go(struct interp *interp, int column, const struct kinematics_great_circle *way,
			    great_circle_pieces_fn go, void *context);

#endif
