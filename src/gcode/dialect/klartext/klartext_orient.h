/* klartext_orient.h - TX, TY, TZ of LN, and AXIS SPAT: the rotary axes that stand the tool in a direction. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_ORIENT_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_ORIENT_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_move.h"

/* Puts the positions of the rotary axes into the target. False: reported. */
bool klartext_orient_target(struct interp *interp, const struct klartext_words *words, struct klartext_target *target);

/* Is no way of a rotary axis from `from` to `a` longer than to `b`? */
bool klartext_orient_is_no_farther(const axis_values *from, const struct kinematics_solution *a,
				   const struct kinematics_solution *b);

/* Does the tool lie along Z of the program's coordinates? False: the kinematics has none, which was reported. */
bool klartext_orient_along_z(struct interp *interp, int column, bool *along);

#endif
