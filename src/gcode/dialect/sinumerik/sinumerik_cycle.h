/* sinumerik_cycle.h - CYCLE81 to CYCLE89, CYCLE840. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_CYCLE_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_CYCLE_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/* Is this the name of a cycle that drills, taps or bores where the tool stands? */
bool sinumerik_cycle_drills(const char *name);

/* Drills by this cycle with these arguments (NAN: left out) where the tool stands. False: reported. */
bool sinumerik_cycle_drill(struct interp *interp, const char *name, const double *arguments, size_t count, int column);

#endif
