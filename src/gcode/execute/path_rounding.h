/* path_rounding.h - how far a control that rounds corners may leave a path that is defined in a plane or a cylinder. */
#ifndef FIVECHECK_GCODE_EXECUTE_PATH_ROUNDING_H
#define FIVECHECK_GCODE_EXECUTE_PATH_ROUNDING_H

#include "gcode/state.h"

/* mm: for a move that motion_commands_fill has completed; the same value as in motion/blend.h for lengths. */
double path_rounding(const struct interp *interp, const struct canon_move *move);

#endif
