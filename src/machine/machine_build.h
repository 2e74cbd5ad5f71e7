/* machine_build.h - judges a description of a machine and makes the machine of it. */
#ifndef FIVECHECK_MACHINE_MACHINE_BUILD_H
#define FIVECHECK_MACHINE_MACHINE_BUILD_H

#include "machine/description.h"
#include "machine/machine.h"

/*
 * Takes over the description's arena, and that of its setup. NULL: the description contradicts itself or says what no
 * machine can be; everything of that kind was reported.
 */
struct machine *machine_build(struct machine_description *described, struct diag *diag);

#endif
