/* klartext_orient.h - TX, TY, TZ of LN, and AXIS SPAT: the positions of the rotary axes for a tool direction. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_PLANES_KLARTEXT_ORIENT_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_PLANES_KLARTEXT_ORIENT_H

#include <stdbool.h>

#include "gcode/dialect/klartext/moves/klartext_move.h"

/* Sets the positions of the rotary axes in the target. False: reported. */
bool klartext_orient_target(struct interp *interp, const struct klartext_words *words, struct klartext_target *target);

/* Is the distance of every rotary axis from `from` to `a` at most that to `b`? */
bool klartext_orient_is_no_farther(const axis_values *from, const struct kinematics_solution *a,
				   const struct kinematics_solution *b);

/* *along: the tool is parallel to Z of the program's coordinates. False: the kinematics has no direction; reported. */
bool klartext_orient_along_z(struct interp *interp, int column, bool *along);

#endif
