/* sinumerik_system.h - system variables ($...) that a program may read. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_SYSTEM_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_SYSTEM_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/* The value of a constant of the language by its upper-case name: TRUE, _ORI_FINISH. False: it is none. */
bool sinumerik_system_constant(const char *name, double *value);

/* Does the interpreter compute the system variable? Its index is the name of an axis, or it has none. */
bool sinumerik_system_follows(const char *name, bool axis);

/* Does it keep values that programs write, such as $AC_MARKER[1]? These values are not followed. */
bool sinumerik_system_is_scratch(const char *name);

/*
 * The value of a system variable that the interpreter computes, by its upper-case name; slot: the axis in its
 * brackets, or -1. False: it is not known here, which was reported at the column.
 */
bool sinumerik_system_read(struct interp *interp, const char *name, int slot, int column, double *value);

/* $TC_DP3 and $TC_DP6: the length and the radius of an edge of a tool, from the setup. False: reported. */
bool sinumerik_system_edge(struct interp *interp, const char *name, int tool, int edge, int column, double *value);

/* The index of the work offset of $P_UIFR[n]: 1 is G54. */
int sinumerik_system_of_offset(int n);

/* $P_UIFR[n, axis, component] for reading: TR is the shift; the setup has no other components. False: reported. */
bool sinumerik_system_offset(struct interp *interp, int n, int slot, const char *component, int column, double *value);

/* $P_TOOLL[length] or, with length 0, $P_TOOLR: of the active edge. False: reported. */
bool sinumerik_system_tool(struct interp *interp, int length, int column, double *value);

#endif
