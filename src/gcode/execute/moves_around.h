/* moves_around.h - moves of a builder's program of which only is known how far they lead from their place. */
#ifndef FIVECHECK_GCODE_EXECUTE_MOVES_AROUND_H
#define FIVECHECK_GCODE_EXECUTE_MOVES_AROUND_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Covers all of the box about the present place, which reaches so many mm along X, Y and Z to both sides, and goes
 * back. TCP and radius compensation are off. False: reported at the column, or the sink wants no more.
 */
bool moves_around_go(struct interp *interp, const double around[3], int column);

#endif
