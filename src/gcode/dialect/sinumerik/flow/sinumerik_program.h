/* sinumerik_program.h - finds a subprogram: a file of its own, or another program in a file with several. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_FLOW_SINUMERIK_PROGRAM_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_FLOW_SINUMERIK_PROGRAM_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/*
 * The upper-case name of the program in a path of CALL or EXTCALL, without folders, _N_ and its type. *type: 'M' of
 * MPF, 'S' of SPF, or 0. False: the path names no program, or it and an earlier one have different folders; reported.
 */
bool sinumerik_program_name(struct interp *interp, const char *path, int column, char name[SINUMERIK_NAME + 1],
			    char *type);

/*
 * The first line of the subprogram with this upper-case name, of this type if it is not 0. False: there is none, or
 * there are several, or it cannot be read; reported.
 */
bool sinumerik_program_find(struct interp *interp, const char *name, char type, int column, struct position *entry);

#endif
