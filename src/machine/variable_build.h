/* variable_build.h - checks the <variable> elements of a described controller or setup and stores their contents. */
#ifndef FIVECHECK_MACHINE_VARIABLE_BUILD_H
#define FIVECHECK_MACHINE_VARIABLE_BUILD_H

#include "machine/description.h"
#include "machine/machine.h"
#include "machine/setup.h"

/* Fills the variables of machine->controller, whose dialect is known; faults are reported. */
void variable_build(struct machine_description *described, struct machine *machine);

/*
 * Fills the setup's variables, if it has any: those of the machine, and its own, which replace variables of the same
 * name. Faults are reported.
 */
void variable_build_setup(struct setup_description *described, const struct machine *machine, struct setup *setup);

#endif
