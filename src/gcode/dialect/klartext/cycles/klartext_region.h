/* klartext_region.h - milling cycles whose region is known, but not the path of the tool in it. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_REGION_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_REGION_H

#include <stdbool.h>

#include "gcode/dialect/klartext/cycles/klartext_parameter.h"

/* A box about a point, both in programmed coordinates, which contains the tool's centre. mm. */
struct klartext_region {
	vec3 centre; /* in the plane */
	double half[2]; /* along X and Y */
	double top, bottom, clear; /* heights: set-up clearance, depth, second set-up clearance */
	double beyond; /* how far the tool may exceed these heights */
	double feed; /* mm/s */
	bool nothing; /* a depth of 0: the cycle is not carried out */
	bool fixed; /* the centre does not depend on the present position */
};

/*
 * The tool moves to the set-up clearance, and then may be anywhere in the region, down to the depth, until it is at
 * the second clearance; its position above the region is then not known. False: reported, or the sink wants no more.
 */
bool klartext_region_carry_out(const struct klartext_call_of *call, const struct klartext_region *region);

/* How far the tool may be from its place along the programmed X and Y after a region, mm. */
void klartext_region_find_aside(const struct interp *interp, double aside[2]);

/* From now on the tool may be anywhere in a rectangle of these half sides (mm) until X and Y are commanded. */
void klartext_region_leave_open(struct interp *interp, double half_x, double half_y);

#endif
