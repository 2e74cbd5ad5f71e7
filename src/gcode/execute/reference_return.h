/* reference_return.h - moves to places of the machine: reference positions (G28, G30) and the tool change position. */
#ifndef FIVECHECK_GCODE_EXECUTE_REFERENCE_RETURN_H
#define FIVECHECK_GCODE_EXECUTE_REFERENCE_RETURN_H

#include <stdbool.h>

#include "gcode/state.h"

/* G28 and G30; G28.1 and G30.1 remember the reference position. */
bool reference_return_go(struct interp *interp);
bool reference_return_remember(struct interp *interp);

/* Moves the axes to the place where the machine changes the tool, if the configuration names one. */
bool reference_return_change_tool(struct interp *interp);

#endif
