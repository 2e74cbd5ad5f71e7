/* controller_build.h - checks what a machine file says about the control and its fixed positions, and builds it. */
#ifndef FIVECHECK_MACHINE_CONTROLLER_BUILD_H
#define FIVECHECK_MACHINE_CONTROLLER_BUILD_H

#include "machine/description.h"
#include "machine/machine.h"

/*
 * controller_build sets machine->controller. controller_build_places adds its places; call it when the machine has its
 * axes. Faults are counted in the description's file.
 */
void controller_build(struct machine_description *described, struct machine *machine);
void controller_build_places(struct machine_description *described, struct machine *machine);

#endif
