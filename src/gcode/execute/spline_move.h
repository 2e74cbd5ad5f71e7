/* spline_move.h - moves on splines of the plane XY: G5, G5.1, and the points between G5.2 and G5.3 of LinuxCNC. */
#ifndef FIVECHECK_GCODE_EXECUTE_SPLINE_MOVE_H
#define FIVECHECK_GCODE_EXECUTE_SPLINE_MOVE_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Carries out the block. The curve becomes straight moves with a box about each (canon_move.spread): what the control
 * follows lies in the boxes. False: reported, or the sink wants no more.
 */
bool spline_move_run(struct interp *interp);

/* Only points stand between G5.2 and G5.3, and in a curve of G6.2. False: the block is none, which was reported. */
bool spline_move_check_block(struct interp *interp);

/* At the end of the program: such a curve has come to its end, too. False: reported. */
bool spline_move_check_end(struct interp *interp);

#endif
