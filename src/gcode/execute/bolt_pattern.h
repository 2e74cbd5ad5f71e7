/* bolt_pattern.h - holes on a circle or an arc, drilled by the active canned cycle (G70, G71 of Haas). */
#ifndef FIVECHECK_GCODE_EXECUTE_BOLT_PATTERN_H
#define FIVECHECK_GCODE_EXECUTE_BOLT_PATTERN_H

#include <stdbool.h>

#include "gcode/state.h"

/* Drills the holes of the block about the present position. False: reported, or the sink wants no more. */
bool bolt_pattern_run(struct interp *interp);

#endif
