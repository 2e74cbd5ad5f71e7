/* spline.h - a rational B-spline with uniform or given knots, and boxes around its pieces. */
#ifndef FIVECHECK_GCODE_EXECUTE_SPLINE_H
#define FIVECHECK_GCODE_EXECUTE_SPLINE_H

#include <stdbool.h>
#include <stddef.h>

#include "geom/vec3.h"

#define SPLINE_POINTS_MAX 1000
#define SPLINE_ORDER_MAX 10

struct spline_point {
	vec3 at; /* mm */
	double weight; /* more than 0 */
};

/*
 * The first and the last knot have multiplicity `order`: the curve starts at the first point and ends at the last one.
 * 2 <= order <= count.
 */
struct spline {
	const struct spline_point *points; /* borrowed */
	size_t count;
	int order; /* degree + 1 */
	/* count + order non-decreasing numbers; borrowed. NULL: 0 (order times), 1, 2 and so on */
	const double *knots;
};

/* A piece of the curve, as a line with a box of these half widths around each of its points. */
struct spline_piece {
	vec3 start, end;
	vec3 beside;
};

/* The number of pieces into which LinuxCNC divides the curve, at equal steps of its parameter. */
size_t spline_piece_count(const struct spline *spline);

/*
 * Finds piece `index`: its boxes contain the curve, and the two arcs by which LinuxCNC connects the ends of the piece
 * along their tangents. False: the curve has no tangent there, or reverses, so that there are no such arcs.
 */
bool spline_piece_find(const struct spline *spline, size_t index, struct spline_piece *piece);

/*
 * The same for the curve without the arcs, from parameter u0 to u1, both between the knots `span` and `span` + 1. These
 * two knots must differ, and order - 1 <= span < count.
 */
struct spline_piece spline_part(const struct spline *spline, size_t span, double u0, double u1);

#endif
