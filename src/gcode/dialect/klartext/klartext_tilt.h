/* klartext_tilt.h - how PLANE describes a plane, as a rotation: spatial and Euler angles, vectors, points. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_TILT_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_TILT_H

#include <stdbool.h>

#include "gcode/state.h"
#include "gcode/text/lexer.h"

/*
 * Reads the kind of plane and its values; the columns of *tilt are the directions of the tilted X, Y and Z. `before` is
 * the tilting in force, which RELATIVE adds to. *reset: PLANE RESET. False: reported.
 */
bool klartext_tilt_read(struct lexer *lexer, const mat3 *before, mat3 *tilt, bool *reset);

/* "PLANE SPATIAL": about the machine's X by the first angle, then Y by the second, then Z by the third; degrees. */
mat3 klartext_tilt_spatial(const double angle[3]);

#endif
