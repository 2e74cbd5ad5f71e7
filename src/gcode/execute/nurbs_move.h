/* nurbs_move.h - moves on the NURBS curves of G6.2: points, weights and knots of X, Y and Z. */
#ifndef FIVECHECK_GCODE_EXECUTE_NURBS_MOVE_H
#define FIVECHECK_GCODE_EXECUTE_NURBS_MOVE_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Takes one block of the curve: G6.2, a point with its knot, or a knot alone. With the last knot the curve becomes
 * straight moves with a box about each (canon_move.spread) that holds it. False: reported, or the sink wants no more.
 */
bool nurbs_move_run(struct interp *interp);

#endif
