/* comp_turn.h - how the compensated path goes from one block to the next at a corner of the programmed path. */
#ifndef FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_TURN_H
#define FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_TURN_H

#include <stdbool.h>

#include "gcode/state.h"

/* The most points at which a path turns between two blocks. */
#define COMP_TURN_POINTS 4

/* Lengths in mm. */
struct comp_turn {
	struct plane_point corner; /* of the programmed path */
	struct plane_point
	    points[COMP_TURN_POINTS]; /* the block before ends at the first, the next starts at the last */
	int count;
	bool on_arc; /* from the first point to the second on an arc about the corner, else on lines */
	double spread; /* how far the path between the points may be beside them */
	double spread_before, spread_after; /* and the whole path of the block before, and of the next one */
};

/* A corner and what leads to it and away from it. Directions are units. */
struct comp_corner_shape {
	const struct comp_way *before, *after;
	struct plane_point at, ahead, onward; /* the corner; the programmed directions before and behind it */
	struct plane_point foot, next_foot; /* the points beside it, across these directions */
	double radius, side;
	double angle; /* radians by which the path turns, positive where the tool goes round the outside */
};

/*
 * Where the two ways beside the path cross, on the inside of the corner: of two crossings the one nearer to it. The
 * feet and the angle need not be given. False: they do not cross.
 */
bool comp_turn_crossing(const struct comp_corner_shape *shape, struct plane_point *found);

/*
 * At the programmed point where the program is, between comp.waiting and
 * `after`. False: the tool cannot go on there, which was reported.
 */
bool comp_turn_find(struct interp *interp, const struct comp_way *after, struct comp_turn *turn);

#endif
