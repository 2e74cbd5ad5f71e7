/* cycle_hole.h - what a canned cycle does at one hole: the moves of drilling, pecking, tapping and boring. */
#ifndef FIVECHECK_GCODE_EXECUTE_CYCLE_HOLE_H
#define FIVECHECK_GCODE_EXECUTE_CYCLE_HOLE_H

#include <stdbool.h>

#include "gcode/state.h"

struct canned_cycle {
	struct interp *interp;
	int code;
	const struct cycle_traits *traits;
	enum axis_slot a, b, depth;	/* the plane, and the axis that drills */
	struct canon_feed feed;
	slot_values at;	/* straight position of the tool */
	slot_values step;	/* from hole to hole */
	int repeats;
	double r, bottom, clear;	/* straight positions on the drilling axis */
	double dwell;	/* seconds */
	bool dwells;
	double peck, peck_less, peck_least;	/* mm: the first; by how much each is less; none is less than that */
	double shift_a, shift_b;	/* aside, where the direction is known */
	bool crosses;	/* R and Z lie the wrong way round */
	double top;	/* straight position of the top of LinuxCNC's counterbore */
	double spread;	/* mm: aside, in a direction of the plane that is not known */
	bool aside;	/* the tool stands so, or on its way there or back */
};

/* A rapid of the plane and of the drilling axis, to this height. False: the sink wants no more. */
bool cycle_hole_rapid(struct canned_cycle *cycle, double height);

/* Is the cycle one that bores upwards from below, with its shift in Q? */
bool cycle_hole_bores_back(const struct canned_cycle *cycle);

/* From over the hole, at R or where a back boring cycle starts, to the retract height. False: as above, or reported. */
bool cycle_hole_make(struct canned_cycle *cycle);

#endif
