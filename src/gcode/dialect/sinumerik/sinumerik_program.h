/* sinumerik_program.h - finds a subprogram: in a file of its own, or as another program in the current file. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_PROGRAM_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_PROGRAM_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/* The name of the program in a path of CALL or EXTCALL: without folders, _N_ and type. False: reported. */
bool sinumerik_program_name(struct interp *interp, const char *path, int column, char name[SINUMERIK_NAME + 1]);

/* The first line of the subprogram with this upper-case name. False: there is none, or it cannot be read; reported. */
bool sinumerik_program_find(struct interp *interp, const char *name, int column, struct position *entry);

#endif
