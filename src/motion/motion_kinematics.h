/* motion_kinematics.h - what the control asks of the machine's kinematics, answered at the place where the axes are. */
#ifndef FIVECHECK_MOTION_MOTION_KINEMATICS_H
#define FIVECHECK_MOTION_MOTION_KINEMATICS_H

#include "gcode/kinematics.h"
#include "motion/canon_to_spans.h"

/* `converter` is borrowed: it is the context, and knows the machine, where its axes are, and whether TCP is on. */
struct kinematics motion_kinematics(struct canon_to_spans *converter);

#endif
