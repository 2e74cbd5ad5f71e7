/* canned_cycle.h - canned cycles: drilling, pecking, tapping and boring, hole by hole. */
#ifndef FIVECHECK_GCODE_EXECUTE_CANNED_CYCLE_H
#define FIVECHECK_GCODE_EXECUTE_CANNED_CYCLE_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Carries out the block's cycle (code_is_cycle) as the moves that the control
 * makes, in its order. LinuxCNC: manual, "Canned Cycles", and the moves of its
 * 2.9 interpreter; Fanuc 30i-B operator's manual (B-64484EN), canned cycle for
 * drilling; Haas mill operator's manual, canned cycles.
 */
bool canned_cycle_run(struct interp *interp);

#endif
