/*
 * kinematics_check.h - compares the motion of the tool relative to the work with ISO 841: X Y Z right-handed, Z along
 * the spindle and away from the work, A B C right-handed about X Y Z.
 */
#ifndef FIVECHECK_MACHINE_KINEMATICS_CHECK_H
#define FIVECHECK_MACHINE_KINEMATICS_CHECK_H

#include "machine/doubt.h"
#include "machine/machine.h"

/* What an axis moves: 1 the tool, -1 the work, 0 neither, both, or unknown. */
int kinematics_side(const struct machine *machine, const struct axis *axis);

/*
 * The unit direction along which, or about which, a positive value moves the tool relative to the work, with all axes
 * at 0. Only for an axis whose side is not 0.
 */
vec3 kinematics_direction(const struct machine *machine, const struct axis *axis);

/*
 * The least and the greatest coordinate of the gauge point along a direction of the drawing, as seen from the
 * workholding's origin, over the travel of the linear axes with the rotary axes at 0. The machine must have a spindle
 * and a workholding.
 */
void kinematics_range(const struct machine *machine, vec3 along, double *least, double *greatest);

/* mm: the longest limited travel of a linear axis that moves tool or work; 0: none is limited. */
double kinematics_longest_travel(const struct machine *machine);

/* Two directions perpendicular to the spindle and to each other. */
void kinematics_sideways(const struct machine *machine, vec3 out[2]);

/*
 * Appends the doubts in the order of enum doubt_kind. Elements marked checked="" are left out. The letters are compared
 * with the drawing's X Y Z.
 */
void kinematics_check(const struct machine *machine, struct doubts *doubts);

#endif
