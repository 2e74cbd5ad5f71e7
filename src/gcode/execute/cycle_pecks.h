/* cycle_pecks.h - how deep each peck of a drilling cycle is. */
#ifndef FIVECHECK_GCODE_EXECUTE_CYCLE_PECKS_H
#define FIVECHECK_GCODE_EXECUTE_CYCLE_PECKS_H

#include <stdbool.h>

#include "gcode/execute/cycle_hole.h"

/* More pecks or holes in one block are a typing mistake, and carrying them out would seem to hang. */
#define CYCLE_COUNT_MAX 1000000

/*
 * Finds the pecks of the cycle, whose heights are known; words of an earlier cycle count if they are kept. False:
 * reported.
 */
bool cycle_pecks_find(struct canned_cycle *cycle, bool kept);

#endif
