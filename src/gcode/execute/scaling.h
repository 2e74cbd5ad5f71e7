/* scaling.h - coordinates scaled about a centre: G51 and G50. */
#ifndef FIVECHECK_GCODE_EXECUTE_SCALING_H
#define FIVECHECK_GCODE_EXECUTE_SCALING_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Fanuc B-64484EN, "Scaling (G50, G51)"; Haas mill operator's manual, "G51 Scaling". The scaled coordinates are a
 * rotated_frame that distorts. What can fail reports why before it returns false.
 */

/* Refuses what cannot be done in scaled coordinates: before anything else of the block. */
bool scaling_start_block(struct interp *interp);

/* Carries out the block's code, if it has one. */
bool scaling_switch(struct interp *interp);

#endif
