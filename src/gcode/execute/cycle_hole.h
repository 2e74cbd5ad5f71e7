/* cycle_hole.h - the moves of a canned cycle at one hole: drilling, pecking, tapping and boring. */
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
	slot_values step;	/* from one hole to the next */
	int repeats;
	double r, bottom, clear;	/* straight positions on the drilling axis */
	double dwell;	/* seconds */
	bool dwells;
	double peck, peck_less, peck_least;	/* mm: the first peck; the decrement of each peck; the smallest peck */
	double shift_a, shift_b;	/* the shift aside, if its direction is known */
	bool crosses;	/* R and Z are in the wrong order */
	double top;	/* straight position of the top of LinuxCNC's counterbore */
	double spread;	/* mm: the shift aside, if its direction in the plane is not known */
	bool aside;	/* the tool is shifted aside, or is moving there or back */
};

/* A rapid in the plane and along the drilling axis, to this height. False: the sink wants no more. */
bool cycle_hole_rapid(struct canned_cycle *cycle, double height);

/* Is the cycle a back boring cycle, from below upwards, with its shift in Q? */
bool cycle_hole_bores_back(const struct canned_cycle *cycle);

/* Makes one hole, from R or the start of a back boring cycle to the retract height. False: as above, or reported. */
bool cycle_hole_make(struct canned_cycle *cycle);

#endif
