/* variable_build.h - judges the <variable> elements of a described controller and keeps what they say. */
#ifndef FIVECHECK_MACHINE_VARIABLE_BUILD_H
#define FIVECHECK_MACHINE_VARIABLE_BUILD_H

#include "machine/description.h"
#include "machine/machine.h"

/* Fills the variables of machine->controller, whose dialect is known; faults are reported. */
void variable_build(struct machine_description *described, struct machine *machine);

#endif
