/* bolt_pattern.h - holes on a circle or an arc, made by the canned cycle in force (G70, G71 of Haas). */
#ifndef FIVECHECK_GCODE_EXECUTE_BOLT_PATTERN_H
#define FIVECHECK_GCODE_EXECUTE_BOLT_PATTERN_H

#include <stdbool.h>

#include "gcode/state.h"

/* Makes the holes of the block about where the tool stands. False: reported, or the sink wants no more. */
bool bolt_pattern_run(struct interp *interp);

#endif
