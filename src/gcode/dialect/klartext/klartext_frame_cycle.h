/* klartext_frame_cycle.h - the cycles that change the way from programmed coordinates to positions. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_FRAME_CYCLE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_FRAME_CYCLE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_state.h"

/*
 * CYCL DEF 7 (datum shift), 8 (mirror image), 10 (rotation), 11 and 26 (scaling): takes effect where its definition
 * ends. False: reported.
 */
bool klartext_frame_cycle_shift(struct interp *interp, const struct klartext_cycle *cycle);
bool klartext_frame_cycle_mirror(struct interp *interp, const struct klartext_cycle *cycle);
bool klartext_frame_cycle_rotate(struct interp *interp, const struct klartext_cycle *cycle);
bool klartext_frame_cycle_scale(struct interp *interp, const struct klartext_cycle *cycle);
bool klartext_frame_cycle_scale_axes(struct interp *interp, const struct klartext_cycle *cycle);

/* Is this shift of the linear axes, or that of another axis, other than 0? */
bool klartext_frame_cycle_is_shifted(const struct interp *interp, vec3 linear);

#endif
