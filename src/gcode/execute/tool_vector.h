/* tool_vector.h - the direction of the tool by I, J and K of each block (G43.5). */
#ifndef FIVECHECK_GCODE_EXECUTE_TOOL_VECTOR_H
#define FIVECHECK_GCODE_EXECUTE_TOOL_VECTOR_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Of a block under G43.5 whose straight end position is *target: sets its rotary slots to the positions that give the
 * tool the direction of I, J and K, from the tip to the spindle. Without any of these the direction stays. False: the
 * machine cannot stand so, or it is not known how it would, which was reported.
 */
bool tool_vector_take(struct interp *interp, slot_values *target);

/*
 * I, J, K and Q under G43.5 belong to straight moves of the program. False: they stand in a block that is
 * no straight move, which was reported.
 */
bool tool_vector_check_block(struct interp *interp);

#endif
