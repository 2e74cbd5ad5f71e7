/* sinumerik_swivel.h - CYCLE800: the working plane is swivelled and the rotary axes stand the tool on it. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_SWIVEL_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_SWIVEL_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/* Carries CYCLE800 out with the arguments read. False: reported, or the sink wants no more. */
bool sinumerik_swivel_run(struct interp *interp, int column);

#endif
