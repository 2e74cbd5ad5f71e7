/* klartext_pattern.h - a cycle at many points: CYCL CALL PAT, and cycles 220 and 221. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_PATTERN_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_PATTERN_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"

/*
 * CYCL CALL PAT: carries out the last defined cycle at every point; `feed` is that between the points, NULL a rapid.
 * False: reported, or the sink wants no more.
 */
bool klartext_pattern_call(struct interp *interp, int column, const struct canon_feed *feed);

/* Carry out cycles 220 and 221 at their definition. False: the same. */
bool klartext_pattern_circle(struct interp *interp, const struct klartext_cycle *cycle);
bool klartext_pattern_lines(struct interp *interp, const struct klartext_cycle *cycle);

#endif
