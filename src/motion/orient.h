/* orient.h - the rotary positions that stand the tool in a given direction to the workpiece (G53.1). */
#ifndef FIVECHECK_MOTION_ORIENT_H
#define FIVECHECK_MOTION_ORIENT_H

#include <stdbool.h>

#include "base/diag.h"
#include "gcode/kinematics.h"
#include "machine/machine.h"

/*
 * For one or two rotary axes anywhere between workpiece and spindle, nutating
 * ones included. With two there are up to two solutions, each in as many turns
 * as the limits allow; of those within the limits the one is chosen that Fanuc
 * controls choose: by the way of the axis that carries the other (of a table
 * and a head: the table), then by the other's. The choice is told as a note. An
 * axis that any angle suits stays. False, with an error at loc: the machine
 * cannot stand so, or two choices are as good as each other.
 */
bool orient_tool(const struct machine *machine, struct srcloc loc, struct diag *diag,
		 struct kinematics_orientation *orientation);

/*
 * Implements kinematics.orientations for this machine: every solution, and no choice. False, with an error at loc: as
 * above.
 */
bool orient_solutions(const struct machine *machine, struct srcloc loc, struct diag *diag,
		      const struct kinematics_orientation *orientation, struct kinematics_solutions *solutions);

#endif
