/* moves_around.h - moves of a machine builder's program of which only the greatest distances are known. */
#ifndef FIVECHECK_GCODE_EXECUTE_MOVES_AROUND_H
#define FIVECHECK_GCODE_EXECUTE_MOVES_AROUND_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Covers the box about the present position, which extends `around` mm along X, Y and Z to both sides, and moves back.
 * TCP and radius compensation are off. False: reported at the column, or the sink wants no more.
 */
bool moves_around_go(struct interp *interp, const double around[3], int column);

#endif
