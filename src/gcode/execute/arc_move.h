/* arc_move.h - carries out G2 and G3: circles and helices in a plane, given by their centre or radius. */
#ifndef FIVECHECK_GCODE_EXECUTE_ARC_MOVE_H
#define FIVECHECK_GCODE_EXECUTE_ARC_MOVE_H

#include <stdbool.h>

#include "gcode/state.h"

/* Carries out the block's arc. False: reported, or the sink wants no more. */
bool arc_move_run(struct interp *interp);

#endif
