/* reference_return.h - moves to fixed places of the machine: reference positions (G28, G30), tool change position. */
#ifndef FIVECHECK_GCODE_EXECUTE_REFERENCE_RETURN_H
#define FIVECHECK_GCODE_EXECUTE_REFERENCE_RETURN_H

#include <stdbool.h>

#include "gcode/state.h"

/* Carry out G28 and G30; and G28.1 and G30.1, which store the reference position. */
bool reference_return_go(struct interp *interp);
bool reference_return_remember(struct interp *interp);

/* Moves the axes to the machine's tool change position, if the configuration has one. */
bool reference_return_change_tool(struct interp *interp);

#endif
