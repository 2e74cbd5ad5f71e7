/* path_rounding.h - how far a control that rounds corners may leave the path where a plane or a cylinder has it. */
#ifndef FIVECHECK_GCODE_EXECUTE_PATH_ROUNDING_H
#define FIVECHECK_GCODE_EXECUTE_PATH_ROUNDING_H

#include "gcode/state.h"

/* mm: of a move that motion_commands_fill has filled in; the same figure as motion/blend.h has for lengths. */
double path_rounding(const struct interp *interp, const struct canon_move *move);

#endif
