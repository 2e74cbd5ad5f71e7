/* control_variable.h - finds what the machine file says about a variable of the control. */
#ifndef FIVECHECK_CONTROL_CONTROL_VARIABLE_H
#define FIVECHECK_CONTROL_CONTROL_VARIABLE_H

#include "control/controller.h"

/* Bytes of a name with its indices, the NUL included. */
#define CONTROL_VARIABLE_NAME 100

/*
 * The name in one spelling: upper case, without blanks: "id220 nr2 idx3" is ID220NR2IDX3. False: it is empty or too
 * long, and `name` is left as it is.
 */
bool control_variable_name_normalise(const char *given, char name[CONTROL_VARIABLE_NAME]);

/* The variable of this normalised name; NULL: the machine file does not have it. */
const struct control_variable *control_variable_find(const struct controller *controller, const char *name);

#endif
