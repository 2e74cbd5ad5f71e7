/* space_arc.h - G2.4 and G3.4 of Fanuc: an arc in space through a point, which two blocks give. */
#ifndef FIVECHECK_GCODE_EXECUTE_SPACE_ARC_H
#define FIVECHECK_GCODE_EXECUTE_SPACE_ARC_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Fanuc B-64484EN, "Three-dimensional Circular Interpolation": the first block gives a point on the way, the second one
 * the end, whose increments count from that point. G2.4 and G3.4 are the same, and modal. Functions that can fail
 * report the fault before they return false.
 */

/* Takes the point on the way from the block, or moves to the end. */
bool space_arc_run(struct interp *interp);

/* Call for each block while an arc waits for its end: the block must give the end, and have no other code. */
bool space_arc_check_block(struct interp *interp);

/* At the end of the program no arc may wait. */
bool space_arc_check_end(struct interp *interp);

#endif
