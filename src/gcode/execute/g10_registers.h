/* g10_registers.h - G10 L10 to L13 of controls whose H and D are registers of their own. */
#ifndef FIVECHECK_GCODE_EXECUTE_G10_REGISTERS_H
#define FIVECHECK_GCODE_EXECUTE_G10_REGISTERS_H

#include <stdbool.h>

#include "gcode/state.h"

/* Is this L of G10 one of them? */
static inline bool g10_registers_take(int mode)
{
	return mode >= 10 && mode <= 13;
}

/* Writes H or its wear, D or its wear. False: reported. */
bool g10_registers_write(struct interp *interp, int mode);

#endif
