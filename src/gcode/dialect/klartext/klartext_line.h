/* klartext_line.h - one line of a Klartext program: which block it is, and who carries it out. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_LINE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_LINE_H

#include <stdbool.h>

#include "gcode/state.h"

/* Carries out the line in hand: the dialect's `statement`, which takes every line. False: reported. */
bool klartext_line_run(struct interp *interp, bool *done);

#endif
