/* system_params.h - LinuxCNC's predefined numbered parameters: offsets, positions, the tool. */
#ifndef FIVECHECK_GCODE_DIALECT_LINUXCNC_SYSTEM_PARAMS_H
#define FIVECHECK_GCODE_DIALECT_LINUXCNC_SYSTEM_PARAMS_H

#include <stdbool.h>

struct interp;

/*
 * LinuxCNC's manual, "Numbered Parameters". Parameters that depend on the machine's state in real time are a fault
 * that says so. Lengths of offsets, references and tools are in the control's own unit (its LINEAR_UNITS:
 * gcode_config.controller.unit), positions in the program's unit, angles in degrees.
 */

/* The value of #number. False: reported at the column. */
bool system_params_number(struct interp *interp, int number, int column, double *value);

/* Can the program write #number? False: reported at the column. */
bool system_params_check_number(struct interp *interp, int number, int column);

/* Carries out the assignments of the current block, and updates offsets and reference positions. */
bool system_params_assign(struct interp *interp);

#endif
