/* control_variable.h - finds a variable of the control in the machine file. */
#ifndef FIVECHECK_CONTROL_CONTROL_VARIABLE_H
#define FIVECHECK_CONTROL_CONTROL_VARIABLE_H

#include "control/controller.h"

/* Bytes of a name with its indices, including the NUL. */
#define CONTROL_VARIABLE_NAME 100

/*
 * The normalised name: upper case, without blanks: "id220 nr2 idx3" is ID220NR2IDX3. False: it is empty or too long,
 * and `name` is unchanged.
 */
bool control_variable_name_normalise(const char *given, char name[CONTROL_VARIABLE_NAME]);

/* The variable with this normalised name; NULL: the machine file does not have it. */
const struct control_variable *control_variable_find(const struct controller *controller, const char *name);

#endif
