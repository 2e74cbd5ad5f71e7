/* system_params.h - parameters that the interpreter fills in: offsets, positions, modes, the tool. */
#ifndef FIVECHECK_GCODE_DIALECT_LINUXCNC_SYSTEM_PARAMS_H
#define FIVECHECK_GCODE_DIALECT_LINUXCNC_SYSTEM_PARAMS_H

#include <stdbool.h>

struct interp;

/*
 * LinuxCNC's manual, "Numbered Parameters", "Predefined Named Parameters".
 * What depends on the machine's state in real time, or on its INI and HAL
 * files, is a fault that says so. Lengths of offsets, references and tools are
 * in the control's own unit (its LINEAR_UNITS: gcode_config.controller.unit), positions in
 * the program's unit, angles in degrees.
 */

/* The value of #number. False: reported at the column. */
bool system_params_number(struct interp *interp, int number, int column, double *value);

/* Is the position one that programs can read? False: reported at the column. */
bool system_params_position_is_plain(struct interp *interp, int slot, int column);

/* Warns once about a work offset that the setup does not define. */
void system_params_work_is_used(struct interp *interp, int system, int column);

/* Can the program write #number? False: reported at the column. */
bool system_params_check_number(struct interp *interp, int number, int column);

/* Writes it, with what that changes of offsets and reference positions. */
void system_params_set_number(struct interp *interp, int number, double value);

/* Names that are LinuxCNC's own, "_x". */
bool system_params_name_exists(const char *name);
bool system_params_name(struct interp *interp, const char *name, int column, double *value);

/* Can the program write #<name>? False: reported at the column. */
bool system_params_check_name(struct interp *interp, const char *name, int column);

/* Reports that there is no parameter of this name; false. */
bool system_params_fault_unknown(struct interp *interp, const char *name, int column);

#endif
