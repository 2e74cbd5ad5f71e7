/* sinumerik_cycle.h - CYCLE81 to CYCLE89, CYCLE840. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_CYCLES_SINUMERIK_CYCLE_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_CYCLES_SINUMERIK_CYCLE_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/* Is this the name of a cycle that drills, taps or bores at the present position? */
bool sinumerik_cycle_drills(const char *name);

/* Carries out this cycle with these arguments (NAN: omitted) at the present position. False: reported. */
bool sinumerik_cycle_drill(struct interp *interp, const char *name, const double *arguments, size_t count, int column);

#endif
