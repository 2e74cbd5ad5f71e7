/* motion_kinematics.h - answers the interpreter's questions about the machine's kinematics at the present position. */
#ifndef FIVECHECK_MOTION_MOTION_KINEMATICS_H
#define FIVECHECK_MOTION_MOTION_KINEMATICS_H

#include "gcode/kinematics.h"
#include "motion/canon_to_spans.h"

/*
 * `converter` is borrowed: it is the context, and knows the machine, the positions of its axes, and whether TCP is on.
 */
struct kinematics motion_kinematics(struct canon_to_spans *converter);

#endif
