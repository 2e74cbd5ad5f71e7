/* comp_turn.h - the compensated path at a corner of the programmed path. */
#ifndef FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_TURN_H
#define FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_TURN_H

#include <stdbool.h>

#include "gcode/state.h"

/* The most points of the path between two blocks. */
#define COMP_TURN_POINTS 4

/* Lengths in mm. */
struct comp_turn {
	struct plane_point corner; /* of the programmed path */
	struct plane_point
	    points[COMP_TURN_POINTS]; /* the block before ends at the first, the next starts at the last */
	int count;
	bool on_arc; /* from the first point to the second on an arc about the corner, else on lines */
	double spread; /* the greatest distance of the true path from the path through the points */
	double spread_before, spread_after; /* the same for the whole path of the block before, and of the next one */
};

/* A corner with the paths before and after it. Directions are unit vectors. */
struct comp_corner_shape {
	const struct comp_way *before, *after;
	struct plane_point at, ahead, onward; /* the corner; the programmed directions before and after it */
	struct plane_point foot, next_foot; /* the points beside the corner, perpendicular to these directions */
	double radius, side;
	double angle; /* radians by which the path turns; positive: the tool is on the outside of the corner */
};

/*
 * Finds the intersection of the two compensated paths, on the inside of the corner; of two intersections, the one
 * nearer to the corner. The feet and the angle need not be given. False: the paths do not cross.
 */
bool comp_turn_crossing(const struct comp_corner_shape *shape, struct plane_point *found);

/*
 * Finds the turn at the present programmed point, between comp.waiting and `after`. False: the tool cannot follow the
 * path there, which was reported.
 */
bool comp_turn_find(struct interp *interp, const struct comp_way *after, struct comp_turn *turn);

#endif
