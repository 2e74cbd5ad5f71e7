/* table_point.h - computes the place to which the table turns a point of the workpiece (G254). */
#ifndef FIVECHECK_MOTION_TABLE_POINT_H
#define FIVECHECK_MOTION_TABLE_POINT_H

#include <stdbool.h>

#include "base/axes.h"
#include "base/diag.h"
#include "machine/machine.h"

/*
 * Implements kinematics.table_point for this machine. False, with an error at loc and *place unchanged: a rotary axis
 * turns the spindle, or the machine's chain does not allow TCP (tcp_init).
 */
bool table_point_find(const struct machine *machine, struct srcloc loc, struct diag *diag, axis_values *place);

#endif
