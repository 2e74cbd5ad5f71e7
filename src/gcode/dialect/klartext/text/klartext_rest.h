/* klartext_rest.h - checks the text of the file after END PGM. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_TEXT_KLARTEXT_REST_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_TEXT_KLARTEXT_REST_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"

/*
 * Reads the rest of the file, which the control ignores. Text there is a caution; another program there would not be
 * checked. False: there is another program, which was reported.
 */
bool klartext_rest_check(struct interp *interp);

#endif
