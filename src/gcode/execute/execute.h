/* execute.h - carries out one checked block; its codes are executed in the controller's order. */
#ifndef FIVECHECK_GCODE_EXECUTE_EXECUTE_H
#define FIVECHECK_GCODE_EXECUTE_EXECUTE_H

#include <stdbool.h>

#include "gcode/state.h"

/* Sets interp->ended at M2 and M30. False: a fault was reported, or the sink wants no more. */
bool execute_block(struct interp *interp);

#endif
