/* cycle_shift.h - the shift of a bore: how far the tool leaves the wall before it retracts. */
#ifndef FIVECHECK_GCODE_EXECUTE_CYCLE_SHIFT_H
#define FIVECHECK_GCODE_EXECUTE_CYCLE_SHIFT_H

#include <stdbool.h>

#include "gcode/execute/cycle_hole.h"

/*
 * Finds shift_a, shift_b, spread and top of a bore (G76, G87) from the words of its block; other cycles have none.
 * `kept`: the words of the cycle before are still valid. Call it when the heights are known. False: reported.
 */
bool cycle_shift_find(struct canned_cycle *cycle, bool kept);

#endif
