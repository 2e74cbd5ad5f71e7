/* setup_build.h - checks the description of a setup and builds the setup on its machine. */
#ifndef FIVECHECK_MACHINE_SETUP_BUILD_H
#define FIVECHECK_MACHINE_SETUP_BUILD_H

#include "machine/description.h"
#include "machine/machine.h"
#include "machine/setup.h"

/*
 * Takes over the description's arena. NULL: the setup contradicts itself or does not fit the machine; every fault was
 * reported. Warnings go to diag.
 */
struct setup *setup_build(struct setup_description *described, const struct machine *machine, struct diag *diag);

#endif
