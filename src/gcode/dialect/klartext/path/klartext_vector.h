/* klartext_vector.h - PATHCTRL VECTOR of FUNCTION TCPM: the tool turns in the plane of its two directions. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_VECTOR_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_VECTOR_H

#include <stdbool.h>

#include "gcode/dialect/klartext/moves/klartext_move.h"

/* Moves straight to the target, whose rotary axes turn the tool. False: reported, or the sink wants no more. */
bool klartext_vector_go(struct interp *interp, int column, const struct klartext_target *target, bool rapid,
			const struct canon_feed *feed);

#endif
