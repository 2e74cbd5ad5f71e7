/* orient.h - the rotary positions that give the tool a direction relative to the workpiece (G53.1). */
#ifndef FIVECHECK_MOTION_ORIENT_H
#define FIVECHECK_MOTION_ORIENT_H

#include <stdbool.h>

#include "base/diag.h"
#include "gcode/kinematics.h"
#include "machine/machine.h"

/*
 * For one or two rotary axes anywhere between workpiece and spindle, including nutating ones. With two there are up to
 * two solutions, each in as many turns as the limits allow. Of those within the limits this chooses the one that Fanuc
 * controls choose: the shortest rotation of the axis that carries the other (of a table and a head: the table), then of
 * the other. A note names the choice. An axis for which any angle is right stays. False, with an error at loc: the
 * machine cannot reach the direction, or two choices are equally good.
 */
bool orient_tool(const struct machine *machine, struct srcloc loc, struct diag *diag,
		 struct kinematics_orientation *orientation);

/*
 * Implements kinematics.orientations for this machine: every solution, without a choice. False, with an error at loc:
 * as above.
 */
bool orient_solutions(const struct machine *machine, struct srcloc loc, struct diag *diag,
		      const struct kinematics_orientation *orientation, struct kinematics_solutions *solutions);

#endif
