/* klartext_plane.h - the PLANE function: tilted working planes, and the moves of the rotary axes. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_PLANES_KLARTEXT_PLANE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_PLANES_KLARTEXT_PLANE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"
#include "gcode/text/lexer.h"

/* Carries out the text after PLANE. False: reported, or the sink wants no more. */
bool klartext_plane_run(struct lexer *lexer);

/* Carries out CYCL DEF 19 at the end of its definition. False: reported, or the sink wants no more. */
bool klartext_plane_cycle(struct interp *interp, const struct klartext_cycle *cycle);

#endif
