/* tool_change.h - T and M6. */
#ifndef FIVECHECK_GCODE_EXECUTE_TOOL_CHANGE_H
#define FIVECHECK_GCODE_EXECUTE_TOOL_CHANGE_H

#include <stdbool.h>

#include "gcode/state.h"

/* Carries out the block's T, if it has one. False: reported. */
bool tool_change_select(struct interp *interp);

/* Carries out the block's M6, if it has one. False: reported, or the sink wants no more. */
bool tool_change_run(struct interp *interp);

#endif
