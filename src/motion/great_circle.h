/* great_circle.h - two rotary axes while the tool turns in the plane of two directions (ORIVECT, PATHCTRL VECTOR). */
#ifndef FIVECHECK_MOTION_GREAT_CIRCLE_H
#define FIVECHECK_MOTION_GREAT_CIRCLE_H

#include <stdbool.h>

#include "base/diag.h"
#include "gcode/kinematics.h"
#include "machine/machine.h"

/*
 * Implement kinematics.direction and kinematics.great_circle for this machine. With a and b the axes from the workpiece
 * to the spindle, t the tool at rotary zero and c = turn(b, beta) t, the tool points to d = turn(a, alpha) c. On the
 * great circle d' = w n x d and d'' = -w^2 d, so that with x = a.d, D = a.(b x c), q = a.b - (b.t) x and M = w a.n
 *     beta' = a.d' / D,   alpha' = (M - beta' q) / (1 - x^2).
 * Bounds of x and D over a piece give bounds of the second derivatives, and of the distance of the axes from the chord;
 * a piece near a position where an axis turns infinitely fast has none. False, with an error at loc: the machine does
 * not have two rotary axes, or cannot reach the direction.
 */
bool great_circle_direction(const struct machine *machine, struct srcloc loc, struct diag *diag,
			    const axis_values *rotary_zero, const axis_values *rotary, vec3 *direction);
bool great_circle_piece(const struct machine *machine, struct srcloc loc, struct diag *diag,
			struct kinematics_great_circle *piece);

#endif
