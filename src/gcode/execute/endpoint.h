/* endpoint.h - the end position that the axis words of a block command. */
#ifndef FIVECHECK_GCODE_EXECUTE_ENDPOINT_H
#define FIVECHECK_GCODE_EXECUTE_ENDPOINT_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * The straight position (rotated_frame.h) at the end of the block's motion. With `machine` the words are machine
 * coordinates. Axes without a word keep their positions. False: reported.
 */
bool endpoint_find(struct interp *interp, bool machine, slot_values *target);

/*
 * The position of one axis for an absolute value, in coordinates with their zero at `origin`: rotary axes turn
 * according to the machine's wrap.
 */
bool endpoint_absolute(struct interp *interp, int slot, double value, double origin, int column, double *target);

#endif
