/* controller_build.h - judges what a machine file says of the control, and of the places that it goes to. */
#ifndef FIVECHECK_MACHINE_CONTROLLER_BUILD_H
#define FIVECHECK_MACHINE_CONTROLLER_BUILD_H

#include "machine/description.h"
#include "machine/machine.h"

/* Sets machine->controller; its places when the machine has its axes. Faults are counted in the description's file. */
void controller_build(struct machine_description *described, struct machine *machine);
void controller_build_places(struct machine_description *described, struct machine *machine);

#endif
