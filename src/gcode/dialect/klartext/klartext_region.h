/* klartext_region.h - a milling cycle of which the region is known in which the tool stays, but not its path. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_REGION_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_REGION_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_parameter.h"

/* A box about a point, both in programmed coordinates: the centre of the tool is in it. mm. */
struct klartext_region {
	vec3 centre; /* in the plane */
	double half[2]; /* along X and Y */
	double top, bottom, clear; /* heights: set-up clearance, depth, second set-up clearance */
	double beyond; /* how far it may go over and under them */
	double feed; /* mm/s */
	bool nothing; /* a depth of 0: the cycle is not carried out */
	bool fixed; /* the centre does not depend on where the tool stands */
};

/*
 * The tool goes to the set-up clearance, and from there on it may be anywhere in the region, down to the depth, until
 * it stands on the second clearance; where it stands over the region stays open. False: reported, or the sink wants no
 * more.
 */
bool klartext_region_carry_out(const struct klartext_call_of *call, const struct klartext_region *region);

/* How far beside its place the tool may stand along the programmed X and Y: a region leaves it anywhere over it. mm. */
void klartext_region_find_aside(const struct interp *interp, double aside[2]);

/* The tool may stand anywhere in a rectangle of these half sides about its place, until X and Y are commanded. mm. */
void klartext_region_leave_open(struct interp *interp, double half_x, double half_y);

#endif
