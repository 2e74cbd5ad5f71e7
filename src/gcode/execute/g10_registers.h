/* g10_registers.h - G10 L10 to L13 of controls whose H and D are separate registers. */
#ifndef FIVECHECK_GCODE_EXECUTE_G10_REGISTERS_H
#define FIVECHECK_GCODE_EXECUTE_G10_REGISTERS_H

#include <stdbool.h>

#include "gcode/state.h"

/* Does G10 with this L write such a register? */
static inline bool g10_registers_take(int mode)
{
	return mode >= 10 && mode <= 13;
}

/* Writes H, the wear of H, D or the wear of D. False: reported. */
bool g10_registers_write(struct interp *interp, int mode);

#endif
