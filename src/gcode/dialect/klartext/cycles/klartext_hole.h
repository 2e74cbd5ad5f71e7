/* klartext_hole.h - the moves of a drilling cycle at one hole, along Z of the programmed coordinates. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_HOLE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_HOLE_H

#include <stdbool.h>

#include "gcode/state.h"

/* Heights are programmed coordinates of Z in mm, feeds mm/s. */
struct klartext_hole {
	double start, bottom, clear; /* set-up clearance, bottom, second set-up clearance */
	double clearance; /* above the reached depth, at the end of the rapid down */
	double feed, out; /* down; up (0: rapid) */
	double peck, less, least; /* 0: without pecks; each peck is smaller by `less`, but at least `least` */
	int chip_breaks; /* number between two retracts; each moves up by break_way only */
	double break_way;
	double aside_x, aside_y; /* shift at the bottom, before the retract */
	double dwell; /* at the bottom, seconds */
	bool turns; /* the cycle itself turns the spindle */
	bool nothing; /* a depth of 0: the cycle is not carried out */
};

/*
 * Makes the hole from the present position to the second set-up clearance. False: the sink wants no more, or reported
 * at the column.
 */
bool klartext_hole_make(struct interp *interp, const struct klartext_hole *hole, int column);

#endif
