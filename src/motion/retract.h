/* retract.h - moves away from the workpiece along the tool's axis. */
#ifndef FIVECHECK_MOTION_RETRACT_H
#define FIVECHECK_MOTION_RETRACT_H

#include <stdbool.h>

#include "base/diag.h"
#include "gcode/kinematics.h"
#include "machine/machine.h"

/*
 * Moves the linear axes X, Y and Z of a machine position along the tool's axis as retract->position gives it, by its
 * distance or up to the first limit. False, with an error at loc and *retract unchanged: the machine's chain does not
 * allow it (tcp_init), or no axis that moves has a limit.
 */
bool retract_along_tool(const struct machine *machine, struct srcloc loc, struct diag *diag,
			struct kinematics_retract *retract);

#endif
