/* canned_cycle.h - canned cycles: drilling, pecking, tapping and boring, hole by hole. */
#ifndef FIVECHECK_GCODE_EXECUTE_CANNED_CYCLE_H
#define FIVECHECK_GCODE_EXECUTE_CANNED_CYCLE_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Carries out the block's cycle (code_is_cycle): the moves that the control
 * makes, in the control's order, as the dialect's cycle_traits say. False:
 * reported, or the sink wants no more.
 */
bool canned_cycle_run(struct interp *interp);

#endif
