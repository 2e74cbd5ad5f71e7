/*
 * klartext_tilt.h - the rotation of a plane of PLANE: by spatial, projected and Euler angles, vectors, points.
 */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_PLANES_KLARTEXT_TILT_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_PLANES_KLARTEXT_TILT_H

#include <stdbool.h>

#include "base/axes.h"
#include "gcode/state.h"
#include "gcode/text/lexer.h"

struct klartext_tilt {
	bool reset; /* PLANE RESET */
	unsigned axes; /* PLANE AXIAL: bits 1 << slot of the axes with given positions; else 0 */
	double angle[SLOT_COUNT]; /* of these, degrees */
	mat3 turn; /* else: the columns are the directions of the tilted X, Y and Z */
};

/*
 * Reads the kind of plane and its values. RELATIVE is relative to the active tilting `before`. False: reported.
 */
bool klartext_tilt_read(struct lexer *lexer, const mat3 *before, struct klartext_tilt *tilt);

/* "PLANE SPATIAL": about the machine's X by the first angle, then Y by the second, then Z by the third; degrees. */
mat3 klartext_tilt_spatial(const double angle[3]);

#endif
