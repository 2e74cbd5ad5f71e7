/* machine_build.h - checks the description of a machine and builds the machine. */
#ifndef FIVECHECK_MACHINE_MACHINE_BUILD_H
#define FIVECHECK_MACHINE_MACHINE_BUILD_H

#include "machine/description.h"
#include "machine/machine.h"

/*
 * Takes over the description's arena, and that of its setup. NULL: the description contradicts itself or describes an
 * impossible machine; every fault was reported.
 */
struct machine *machine_build(struct machine_description *described, struct diag *diag);

#endif
