/* cylinder.h - cylindrical interpolation (G7.1): arcs on the surface of a cylinder that a rotary axis turns. */
#ifndef FIVECHECK_GCODE_EXECUTE_CYLINDER_H
#define FIVECHECK_GCODE_EXECUTE_CYLINDER_H

#include <stdbool.h>

#include "gcode/state.h"

/* Carries out G7.1. False: reported. */
bool cylinder_switch(struct interp *interp);

/* Refuses what is not possible on the surface. False: reported. */
bool cylinder_check_block(struct interp *interp);

/*
 * Carries out G2 or G3 on the surface by straight moves, with the distances that the axes may be from these moves
 * (canon_move.spread). False: reported, or the sink wants no more.
 */
bool cylinder_arc(struct interp *interp);

#endif
