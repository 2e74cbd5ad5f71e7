/*
 * sinumerik_swivel.h - CYCLE800: swivels the working plane, and turns the rotary axes so that the tool is
 * perpendicular to it.
 */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_CYCLES_SINUMERIK_SWIVEL_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_CYCLES_SINUMERIK_SWIVEL_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/* Executes CYCLE800 with the arguments that were read. False: reported, or the sink wants no more. */
bool sinumerik_swivel_run(struct interp *interp, int column);

#endif
