/* canned_cycle.h - canned cycles: drilling, pecking, tapping and boring, hole by hole. */
#ifndef FIVECHECK_GCODE_EXECUTE_CANNED_CYCLE_H
#define FIVECHECK_GCODE_EXECUTE_CANNED_CYCLE_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Carries out the block's cycle (code_is_cycle): makes the control's moves in the control's order, according to the
 * dialect's cycle_traits. False: reported, or the sink wants no more.
 */
bool canned_cycle_run(struct interp *interp);

#endif
