/* program_position.h - the position that a program reads in its variables. */
#ifndef FIVECHECK_GCODE_EXECUTE_PROGRAM_POSITION_H
#define FIVECHECK_GCODE_EXECUTE_PROGRAM_POSITION_H

#include <stdbool.h>

#include "gcode/state.h"

/* Can the position of this axis be read? False: reported at the column. */
bool program_position_check(struct interp *interp, int slot, int column);

/* The coordinate in the program's system and unit; degrees for a rotary axis. */
double program_position_value(const struct state *state, int slot);

#endif
