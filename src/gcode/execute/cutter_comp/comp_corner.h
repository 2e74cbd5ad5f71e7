/* comp_corner.h - where two compensated paths cross at an inside corner: plane geometry. */
#ifndef FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_CORNER_H
#define FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_CORNER_H

#include <stdbool.h>

#include "gcode/execute/arc.h"

/* A path of the tool's centre: a line through a point with a direction (unit), or a circle. */
struct comp_way {
	bool is_arc;
	struct plane_point point, direction;
	struct plane_point centre;
	double radius;
	bool clockwise;
	bool inside;	/* the tool lies within the programmed arc */
};

/*
 * The corner of an inside turn: where the tool's centre leaves `before` for
 * `after`. Of two crossings the one that LinuxCNC takes (interp_convert.cc).
 * False: they do not cross.
 */
bool comp_corner(const struct comp_way *before, const struct comp_way *after, struct plane_point *corner);

#endif
