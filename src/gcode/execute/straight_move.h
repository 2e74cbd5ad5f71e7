/* straight_move.h - G0 and G1, in program coordinates or, with G53, in machine coordinates. */
#ifndef FIVECHECK_GCODE_EXECUTE_STRAIGHT_MOVE_H
#define FIVECHECK_GCODE_EXECUTE_STRAIGHT_MOVE_H

#include <stdbool.h>

#include "gcode/state.h"

/* Carries out the block's straight move. False: reported, or the sink wants no more. */
bool straight_move_run(struct interp *interp);

#endif
