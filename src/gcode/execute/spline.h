/* spline.h - a rational B-spline over uniform or given knots, and boxes about its pieces. */
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
 * The first knot and the last one stand `order` times each: the curve starts in the first point and ends in the last
 * one. 2 <= order <= count.
 */
struct spline {
	const struct spline_point *points; /* borrowed */
	size_t count;
	int order; /* degree + 1 */
	/* count + order of them, which never fall; borrowed. NULL: 0 (order times), 1, 2 and so on */
	const double *knots;
};

/* A piece of the curve, as a line with a box of these half widths about each of its points. */
struct spline_piece {
	vec3 start, end;
	vec3 beside;
};

/* The number of pieces into which LinuxCNC cuts the curve, at equal steps of its parameter. */
size_t spline_piece_count(const struct spline *spline);

/*
 * Piece `index`: its boxes hold the curve, and the two arcs by which LinuxCNC joins the ends of the piece in their
 * tangents. False: the curve has no tangent there, or turns back, so that there are no such arcs.
 */
bool spline_piece_find(const struct spline *spline, size_t index, struct spline_piece *piece);

/*
 * The curve alone, from u0 to u1, which both lie between the knots `span` and `span` + 1; these two knots differ, and
 * order - 1 <= span < count.
 */
struct spline_piece spline_part(const struct spline *spline, size_t span, double u0, double u1);

#endif
