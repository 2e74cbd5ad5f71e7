/* sinumerik_builder.h - the machine builder's programs, and measuring cycles, which the machine file defines. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_BUILDER_SINUMERIK_BUILDER_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_BUILDER_SINUMERIK_BUILDER_H

#include "gcode/state.h"

/* The number of a subprogram such as L9810; 0: the name is not of this form. */
long sinumerik_builder_number(const char *name);

/* Does the machine file define the program with this upper-case name by <macro>? */
bool sinumerik_builder_is_known(const struct interp *interp, const char *name);

/* Does the machine file say by action="none" that the program with this upper-case name moves nothing? */
bool sinumerik_builder_does_nothing(const struct interp *interp, const char *name);

/* H5 or H1=5: an auxiliary function that moves nothing according to <macro program="H5">. False: reported. */
bool sinumerik_builder_take_auxiliary(struct interp *interp, double value, int column);

/* Reports that a cycle of Siemens, `what`, is not supported, with advice if there is any; false. */
bool sinumerik_builder_refuse(struct interp *interp, const char *name, const char *what, int column);

/* Carries out a program that the machine file defines. False: reported, or the sink wants no more. */
bool sinumerik_builder_run(struct interp *interp, const char *name, int column);

#endif
