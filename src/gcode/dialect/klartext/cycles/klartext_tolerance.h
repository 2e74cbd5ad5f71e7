/* klartext_tolerance.h - CYCL DEF 32: how far the control may leave the programmed path. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_TOLERANCE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_TOLERANCE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"

/* Sets the path tolerance that a line of the cycle gives. False: reported. */
bool klartext_tolerance_set(struct interp *interp, const struct klartext_cycle *cycle);

#endif
