/* cycle_pecks.h - the depth of each peck of a drilling cycle. */
#ifndef FIVECHECK_GCODE_EXECUTE_CYCLE_PECKS_H
#define FIVECHECK_GCODE_EXECUTE_CYCLE_PECKS_H

#include <stdbool.h>

#include "gcode/execute/cycle_hole.h"

/* More pecks or holes in one block are a typing mistake, and the program would seem to hang on them. */
#define CYCLE_COUNT_MAX 1000000

/*
 * Finds the pecks of the cycle; its heights must be known. kept: words of an earlier cycle are still valid. False:
 * reported.
 */
bool cycle_pecks_find(struct canned_cycle *cycle, bool kept);

#endif
