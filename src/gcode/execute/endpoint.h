/* endpoint.h - where the axis words of a block lead. */
#ifndef FIVECHECK_GCODE_EXECUTE_ENDPOINT_H
#define FIVECHECK_GCODE_EXECUTE_ENDPOINT_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * The straight position (rotated_frame.h) at the end of the block's motion.
 * With `machine` the words are machine coordinates. Axes without a word stay.
 * False: reported.
 */
bool endpoint_find(struct interp *interp, bool machine, slot_values *target);

/*
 * The position for an absolute value of one axis, in coordinates that start at
 * `origin`: rotary axes turn as the machine's wrap says.
 */
bool endpoint_absolute(struct interp *interp, int slot, double value, double origin, int column, double *target);

#endif
