/* feedback_moves.h - moves that follow the spindle or a probe: threading, rigid tapping, probing. */
#ifndef FIVECHECK_GCODE_EXECUTE_FEEDBACK_MOVES_H
#define FIVECHECK_GCODE_EXECUTE_FEEDBACK_MOVES_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Carries out G33, G33.1 and G38.2 to G38.5 (LinuxCNC's manual, the sections of these names). If only the machine knows
 * the end of a move, the move covers its whole path. False: reported, or the sink wants no more.
 */
bool feedback_moves_run(struct interp *interp);

#endif
