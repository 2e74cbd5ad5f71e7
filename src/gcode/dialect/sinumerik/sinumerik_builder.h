/* sinumerik_builder.h - programs of the machine's builder, and measuring cycles, of which the machine file tells. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_BUILDER_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_BUILDER_H

#include "gcode/state.h"

/* The number of a subprogram L9810; 0: the name is another one. */
long sinumerik_builder_number(const char *name);

/* Does the machine file say with <macro> what the program with this upper-case name does? */
bool sinumerik_builder_is_known(const struct interp *interp, const char *name);

/* Does the machine file say with action="none" that what has this upper-case name moves nothing? */
bool sinumerik_builder_does_nothing(const struct interp *interp, const char *name);

/* H5 or H1=5: an auxiliary function, of which <macro program="H5"> says that it does nothing. False: reported. */
bool sinumerik_builder_take_auxiliary(struct interp *interp, double value, int column);

/* Reports that a cycle of Siemens, `what`, is not followed, and the answer to it if there is one; false. */
bool sinumerik_builder_refuse(struct interp *interp, const char *name, const char *what, int column);

/* Does what the machine file says of a program that it knows. False: reported, or the sink wants no more. */
bool sinumerik_builder_run(struct interp *interp, const char *name, int column);

#endif
