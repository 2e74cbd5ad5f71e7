/* nurbs_move.h - moves on the NURBS curves of G6.2: points, weights and knots of X, Y and Z. */
#ifndef FIVECHECK_GCODE_EXECUTE_NURBS_MOVE_H
#define FIVECHECK_GCODE_EXECUTE_NURBS_MOVE_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Reads one block of the curve: G6.2, a point with its knot, or only a knot. At the last knot the curve is sent as
 * straight moves, each with a box (canon_move.spread) that contains its piece of the curve. False: reported, or the
 * sink wants no more.
 */
bool nurbs_move_run(struct interp *interp);

#endif
