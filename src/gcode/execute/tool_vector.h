/* tool_vector.h - the direction of the tool given by I, J and K of each block (G43.5). */
#ifndef FIVECHECK_GCODE_EXECUTE_TOOL_VECTOR_H
#define FIVECHECK_GCODE_EXECUTE_TOOL_VECTOR_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * For a block under G43.5 with the straight end position *target: sets its rotary slots to the positions that give the
 * tool the direction of I, J and K, from the tip to the spindle. Without any of these words the direction does not
 * change. False: the machine cannot reach the direction, or its choice is not known; this was reported.
 */
bool tool_vector_take(struct interp *interp, slot_values *target);

/*
 * Are I, J, K and Q under G43.5 only in straight moves of the program? False: a block that is no straight move has
 * them, which was reported.
 */
bool tool_vector_check_block(struct interp *interp);

#endif
