/* path_control.h - codes for the accuracy of the path: G5, G5.1 and G8 of Fanuc, G187 and G103 of Haas. */
#ifndef FIVECHECK_GCODE_EXECUTE_PATH_CONTROL_H
#define FIVECHECK_GCODE_EXECUTE_PATH_CONTROL_H

#include <stdbool.h>

#include "gcode/state.h"

/* Carries out such a code of the block, if it has one. False: reported. */
bool path_control_select(struct interp *interp);

#endif
