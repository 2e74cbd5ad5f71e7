/* cell_part.h - the part of a box that may be near an obstacle: the intersection of the box with a half-space. */
#ifndef FIVECHECK_STOCK_CELL_PART_H
#define FIVECHECK_STOCK_CELL_PART_H

#include "geom/vec3.h"

/* The points x with a normal . (x - centre) of at most `offset`. A normal of 0 means all points. */
struct half_space {
	vec3 normal;	/* unit, or 0 */
	double offset;	/* mm */
};

/* The corners of the box, and one place on each edge: more than there can be. */
enum { CELL_PART_POINTS = 20 };

struct cell_part {
	vec3 points[CELL_PART_POINTS];	/* it is their convex hull */
	int count;	/* 0: the intersection is empty */
	vec3 low, high, middle;	/* the box around them, and the mean of them; valid unless count is 0 */
};

/* The intersection of the half-space with the box about `centre`; `half` holds the halves of the edges. */
void cell_part_init(struct cell_part *part, vec3 centre, vec3 half, const struct half_space *space);

#endif
