/* klartext_frame_cycle.h - the cycles that change the conversion of programmed coordinates to positions. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_FRAMES_KLARTEXT_FRAME_CYCLE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_FRAMES_KLARTEXT_FRAME_CYCLE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"

/*
 * CYCL DEF 7 (datum shift), 8 (mirror image), 10 (rotation), 11 and 26 (scaling) take effect at the end of their
 * definition. False: reported.
 */
bool klartext_frame_cycle_shift(struct interp *interp, const struct klartext_cycle *cycle);
bool klartext_frame_cycle_mirror(struct interp *interp, const struct klartext_cycle *cycle);
bool klartext_frame_cycle_rotate(struct interp *interp, const struct klartext_cycle *cycle);
bool klartext_frame_cycle_scale(struct interp *interp, const struct klartext_cycle *cycle);
bool klartext_frame_cycle_scale_axes(struct interp *interp, const struct klartext_cycle *cycle);

/* Is this shift of the linear axes, or the shift of another axis, not 0? */
bool klartext_frame_cycle_is_shifted(const struct interp *interp, vec3 linear);

#endif
