/* comp_corner.h - the intersection of two compensated paths at an inside corner: plane geometry. */
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
	bool inside;	/* the tool is inside the programmed arc */
};

/*
 * Finds the point of an inside corner where the tool's centre changes from path `before` to path `after`. If the paths
 * cross twice, it is the intersection that LinuxCNC takes (interp_convert.cc). False: they do not cross.
 */
bool comp_corner(const struct comp_way *before, const struct comp_way *after, struct plane_point *corner);

#endif
