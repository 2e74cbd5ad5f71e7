/* macro_b_vars.h - reads and writes the variables of macros: local, common, and system variables. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_VARS_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_VARS_H

#include <stdbool.h>

struct interp;

/* The value of #number, NAN if it is vacant. False: reported at the column. */
bool macro_b_vars_read(struct interp *interp, int number, int column, double *value);

/* Assigns a value, or NAN for vacant, to #number. False: reported at the column. */
bool macro_b_vars_write(struct interp *interp, int number, int column, double value);

/* A program of the machine builder, which may set any common variable, has run. */
void macro_b_vars_doubt(struct interp *interp);

#endif
