/* sinumerik_program.h - where a subprogram is: a file of its own, or another program in the file in hand. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_PROGRAM_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_PROGRAM_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/* The program name in a path, as CALL and EXTCALL take it: no folders, no _N_, no type. False: reported. */
bool sinumerik_program_name(struct interp *interp, const char *path, int column, char name[SINUMERIK_NAME + 1]);

/* The first line of the subprogram with this upper-case name. False: reported, also where there is none. */
bool sinumerik_program_find(struct interp *interp, const char *name, int column, struct position *entry);

#endif
