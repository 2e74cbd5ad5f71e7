/* carry.h - where turning the table takes a point of the workpiece (G254). */
#ifndef FIVECHECK_MOTION_CARRY_H
#define FIVECHECK_MOTION_CARRY_H

#include <stdbool.h>

#include "base/axes.h"
#include "base/diag.h"
#include "machine/machine.h"

/*
 * *place holds, of the linear axes, the position that brings the gauge point to
 * a point of the workpiece while every rotary axis is at 0, and of the rotary
 * ones the angles at which they are now; X Y Z receive the position that brings
 * the gauge point there now. False, with an error at loc: a rotary axis turns
 * the spindle, or TCP is nothing for this machine (tcp_init).
 */
bool carry_point(const struct machine *machine, struct srcloc loc, struct diag *diag, axis_values *place);

#endif
