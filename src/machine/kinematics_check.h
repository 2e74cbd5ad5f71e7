/*
 * kinematics_check.h - how the tool moves against the work, and where that is not as ISO 841 names and signs axes:
 * X Y Z right-handed, Z along the spindle and away from the work, A B C right-handed about X Y Z, all of
 * them for the tool as the work sees it.
 */
#ifndef FIVECHECK_MACHINE_KINEMATICS_CHECK_H
#define FIVECHECK_MACHINE_KINEMATICS_CHECK_H

#include "machine/doubt.h"
#include "machine/machine.h"

/* What an axis moves: 1 the tool, -1 the work, 0 neither, both, or the file does not say. */
int kinematics_side(const struct machine *machine, const struct axis *axis);

/*
 * Along or about which direction a positive value moves the tool against the work, all axes at 0; unit. Only
 * for an axis with a side.
 */
vec3 kinematics_direction(const struct machine *machine, const struct axis *axis);

/*
 * The gauge point as seen from the workholding's origin, along a direction of the drawing: the least and the
 * greatest over the travel of the linear axes, the rotary ones at 0. The machine has both.
 */
void kinematics_range(const struct machine *machine, vec3 along, double *least, double *greatest);

/* The longest limited travel of a linear axis that moves tool or work, mm; 0: none is limited. */
double kinematics_longest_travel(const struct machine *machine);

/* Two directions across the spindle and each other. */
void kinematics_sideways(const struct machine *machine, vec3 out[2]);

/*
 * Appends what is doubtful, in the order of enum doubt_kind; what the file marks as checked="" is left out.
 * The drawing's X Y Z are the reference for the letters.
 */
void kinematics_check(const struct machine *machine, struct doubts *doubts);

#endif
