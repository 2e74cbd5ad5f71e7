/* klartext_tangent.h - the circles of APPR and DEP, and the lines tangent to them. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_MOVES_KLARTEXT_TANGENT_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_MOVES_KLARTEXT_TANGENT_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"

/*
 * All in the plane of X and Y of programmed coordinates, mm; `side` is 1 where the tool is on the left of the contour.
 */

/* Projects the direction of a line or a helix, which may rise, to the plane. False: it has none there. */
bool klartext_tangent_flatten(vec3 *direction);

/* The unit vector from a contour in this direction (unit, in the plane) to the side of the tool. */
vec3 klartext_tangent_across(vec3 direction, int side);

/* The vector turned counter-clockwise by an angle in radians. */
vec3 klartext_tangent_turned(vec3 v, double angle);

/* The circle of CT and LCT as a contour: the compensated path of the tool's centre has the radius R. */
struct klartext_tangent_circle {
	vec3 centre;
	double radius;
	int turn; /* 1: counter-clockwise */
};

/*
 * The circle tangent to the contour at this point, for the tool and the side of interp->comp. R < 0: it is on the
 * side of the workpiece. R is the radius of the path of the tool's centre: in the examples CIRCULAR, LINEARPO and HELIX
 * of the TNC 426 and TNC 640 user's manuals ("Programming contours") R is less than the tool's radius.
 * False: reported.
 */
bool klartext_tangent_circle_find(struct interp *interp, vec3 point, vec3 direction,
				  const struct klartext_way_words *words, struct klartext_tangent_circle *circle);

/* The other end of a path of APPR and DEP: PH or PN as a point of the contour, and the tool's centre at that point. */
struct klartext_tangent_helper {
	vec3 contour, tool;
};

/*
 * The point where the line from the tool's centre `from` is tangent to the path of the centre around the circle.
 * `turn` is 1 if the path after it is counter-clockwise. False: `from` is inside the circle, which was reported.
 */
bool klartext_tangent_touch(struct interp *interp, vec3 from, const struct klartext_tangent_circle *circle,
			    const struct klartext_way_words *words, int turn, struct klartext_tangent_helper *helper);

#endif
