/*
 * controller_build.h - checks the description of the control and its fixed positions in a machine file, and builds
 * both.
 */
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
