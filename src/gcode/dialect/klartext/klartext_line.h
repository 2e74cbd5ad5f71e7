/* klartext_line.h - reads a line: comments, block numbers, lines that continue a block or a definition. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_LINE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_LINE_H

#include <stdbool.h>

#include "gcode/state.h"

/* Carries out the current line: the dialect's `statement`, which takes every line. False: reported. */
bool klartext_line_run(struct interp *interp, bool *done);

#endif
