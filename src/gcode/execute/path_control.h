/* path_control.h - how exactly a control keeps to the path: Fanuc's G5, G5.1 and G8, Haas's G187 and G103. */
#ifndef FIVECHECK_GCODE_EXECUTE_PATH_CONTROL_H
#define FIVECHECK_GCODE_EXECUTE_PATH_CONTROL_H

#include <stdbool.h>

#include "gcode/state.h"

/* Carries out such a code of the block, if it has one. False: reported. */
bool path_control_select(struct interp *interp);

#endif
