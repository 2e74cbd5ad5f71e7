/* orient.h - the rotary positions that stand the tool in a given direction to the workpiece (G53.1). */
#ifndef FIVECHECK_MOTION_ORIENT_H
#define FIVECHECK_MOTION_ORIENT_H

#include <stdbool.h>

#include "base/diag.h"
#include "gcode/canon.h"
#include "machine/machine.h"

/*
 * For one or two rotary axes anywhere between workpiece and spindle, nutating
 * ones included. With two there are up to two solutions, each in as many turns
 * as the limits allow; of those within the limits the one is chosen that takes
 * the smallest sum of rotary ways from where the axes are. The choice is told as a note, a
 * tie as a warning: what the control takes then depends on its parameters. An
 * axis that any angle suits stays. False, with an error at loc: the machine
 * cannot stand so.
 */
bool orient_tool(const struct machine *machine, struct srcloc loc, struct diag *diag,
		 struct canon_orientation *orientation);

#endif
