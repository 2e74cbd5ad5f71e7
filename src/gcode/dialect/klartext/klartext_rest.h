/* klartext_rest.h - what stands in the file behind END PGM. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_REST_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_REST_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_state.h"

/*
 * Reads the rest of the file: the control reads nothing of it. Text there is a caution; another program there would
 * not be checked. False: there is one, which was reported.
 */
bool klartext_rest_check(struct interp *interp);

#endif
