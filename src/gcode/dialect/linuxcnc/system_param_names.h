/* system_param_names.h - LinuxCNC's predefined named parameters, such as #<_x>. */
#ifndef FIVECHECK_GCODE_DIALECT_LINUXCNC_SYSTEM_PARAM_NAMES_H
#define FIVECHECK_GCODE_DIALECT_LINUXCNC_SYSTEM_PARAM_NAMES_H

#include <stdbool.h>

struct interp;

/*
 * LinuxCNC's manual, "Predefined Named Parameters". Parameters that depend on the machine's state in real time, or on
 * its INI and HAL files, are a fault that says so. Positions are in the program's unit, angles in degrees.
 */

/* Is this one of LinuxCNC's own names? */
bool system_param_names_has(const char *name);

/* The value of such a name. False: reported at the column. */
bool system_param_names_read(struct interp *interp, const char *name, int column, double *value);

/* Can the program write #<name>? False: reported at the column. */
bool system_param_names_check_write(struct interp *interp, const char *name, int column);

/* Reports that there is no parameter of this name; false. */
bool system_param_names_fault_unknown(struct interp *interp, const char *name, int column);

#endif
