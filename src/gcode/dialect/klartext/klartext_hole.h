/* klartext_hole.h - what a drilling cycle does at one hole, along Z of the programmed coordinates. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_HOLE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_HOLE_H

#include <stdbool.h>

#include "gcode/state.h"

/* Heights are programmed coordinates of Z in mm, feeds mm/s. */
struct klartext_hole {
	double start, bottom, clear; /* set-up clearance, bottom, second set-up clearance */
	double clearance; /* over the depth reached, where the rapid down ends */
	double feed, out; /* down; up, 0: at the rapid rate */
	double peck, less, least; /* 0: in one go; each peck is smaller by `less`, but for `least` */
	int chip_breaks; /* between two pecks, up by break_way only */
	double break_way;
	double aside_x, aside_y; /* at the bottom, before it goes up */
	double dwell; /* at the bottom, seconds */
	bool turns; /* the cycle itself turns the spindle */
	bool nothing; /* a depth of 0: the cycle is not carried out */
};

/*
 * From where the tool stands to the second set-up clearance. False: the sink wants no more, or reported at the
 * column.
 */
bool klartext_hole_make(struct interp *interp, const struct klartext_hole *hole, int column);

#endif
