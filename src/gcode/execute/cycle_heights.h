/* cycle_heights.h - the heights of a canned cycle: R, the bottom and the retract. */
#ifndef FIVECHECK_GCODE_EXECUTE_CYCLE_HEIGHTS_H
#define FIVECHECK_GCODE_EXECUTE_CYCLE_HEIGHTS_H

#include <stdbool.h>

#include "gcode/execute/cycle_hole.h"

/*
 * Finds r, bottom, clear and crosses of the cycle from the words of its block and the initial level; `kept`: the words
 * of the cycle before are still valid. False: reported.
 */
bool cycle_heights_find(struct canned_cycle *cycle, bool kept);

#endif
