/* feedback_moves.h - moves whose end only the machine knows, as full travel: threading, rigid tapping, probing. */
#ifndef FIVECHECK_GCODE_EXECUTE_FEEDBACK_MOVES_H
#define FIVECHECK_GCODE_EXECUTE_FEEDBACK_MOVES_H

#include <stdbool.h>

#include "gcode/state.h"

/* G33, G33.1, G38.2 to G38.5 (LinuxCNC's manual, the sections of these names). */
bool feedback_moves_run(struct interp *interp);

#endif
