/* macro_b_system.h - system variables of macros: modes, positions, work offsets. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_SYSTEM_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_SYSTEM_H

#include <stdbool.h>

struct interp;

/*
 * The variables from #1000 on (B-63944EN, system variables; Haas mill operator's manual, system variables). Variables
 * that only the running machine knows are a fault that says so. Lengths are in the program's unit. False: reported at
 * the column.
 */
bool macro_b_system_read(struct interp *interp, int number, int column, double *value);
bool macro_b_system_write(struct interp *interp, int number, int column, double value);

#endif
