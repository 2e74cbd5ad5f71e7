/* scaling.h - scales coordinates about a centre: G51 and G50. */
#ifndef FIVECHECK_GCODE_EXECUTE_SCALING_H
#define FIVECHECK_GCODE_EXECUTE_SCALING_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Fanuc B-64484EN, "Scaling (G50, G51)"; Haas mill operator's manual, "G51 Scaling". The scaled coordinates are a
 * rotated_frame that distorts. Functions that can fail report the reason before they return false.
 */

/* Call first for each block: refuses what is not possible in scaled coordinates. */
bool scaling_start_block(struct interp *interp);

/* Carries out the block's code, if it has one. */
bool scaling_switch(struct interp *interp);

#endif
