/* spline_move.h - moves on splines in the plane XY: G5, G5.1, and the points between G5.2 and G5.3 of LinuxCNC. */
#ifndef FIVECHECK_GCODE_EXECUTE_SPLINE_MOVE_H
#define FIVECHECK_GCODE_EXECUTE_SPLINE_MOVE_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Carries out the block. The curve is sent as straight moves, each with a box (canon_move.spread): the control's path
 * is in the boxes. False: reported, or the sink wants no more.
 */
bool spline_move_run(struct interp *interp);

/* Between G5.2 and G5.3, and in a curve of G6.2: is the block a point, as it must be? False: reported. */
bool spline_move_check_block(struct interp *interp);

/* At the end of the program: is every such curve complete? False: reported. */
bool spline_move_check_end(struct interp *interp);

#endif
