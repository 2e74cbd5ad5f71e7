/* comp_turn.h - how the compensated path goes from one block to the next at a corner of the programmed path. */
#ifndef FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_TURN_H
#define FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_TURN_H

#include <stdbool.h>

#include "gcode/state.h"

/* The most points at which a path turns between two blocks. */
#define COMP_TURN_POINTS 4

/* Lengths in mm. */
struct comp_turn {
	struct plane_point corner;	/* of the programmed path */
	struct plane_point points[COMP_TURN_POINTS];	/* the block before ends at the first, the next starts at the last */
	int count;
	bool on_arc;	/* from the first point to the second on an arc about the corner, else on lines */
	double spread;	/* how far the path between the points may be beside them */
	double spread_before, spread_after;	/* and the whole path of the block before, and of the next one */
};

/*
 * At the programmed point where the program is, between comp.waiting and
 * `after`. False: the tool cannot go on there, which was reported.
 */
bool comp_turn_find(struct interp *interp, const struct comp_way *after, struct comp_turn *turn);

#endif
