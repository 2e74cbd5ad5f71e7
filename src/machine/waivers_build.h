/* waivers_build.h - checks described waivers and makes the list of waivers for a machine. */
#ifndef FIVECHECK_MACHINE_WAIVERS_BUILD_H
#define FIVECHECK_MACHINE_WAIVERS_BUILD_H

#include "machine/description.h"
#include "machine/machine.h"
#include "machine/waivers.h"

/* Takes over the description's arena. NULL: faults were reported. */
struct waivers *waivers_build(struct waivers_description *described, const struct machine *machine);

#endif
