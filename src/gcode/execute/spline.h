/* spline.h - a rational B-spline of the plane over uniform knots, and boxes about its pieces. */
#ifndef FIVECHECK_GCODE_EXECUTE_SPLINE_H
#define FIVECHECK_GCODE_EXECUTE_SPLINE_H

#include <stdbool.h>
#include <stddef.h>

#define SPLINE_POINTS_MAX 1000
#define SPLINE_ORDER_MAX 10

struct spline_point {
	double x, y; /* mm */
	double weight; /* more than 0 */
};

/*
 * The knots are 0 (order times), 1, 2 and so on, and the last one order times: the curve starts in the first point and
 * ends in the last one. 2 <= order <= count.
 */
struct spline {
	const struct spline_point *points; /* borrowed */
	size_t count;
	int order; /* degree + 1 */
};

/*
 * A piece of the curve, as a line from (x0, y0) to (x1, y1) with a box of these half widths about each of its points.
 */
struct spline_piece {
	double x0, y0, x1, y1;
	double beside_x, beside_y;
};

/* The number of pieces into which LinuxCNC cuts the curve, at equal steps of its parameter. */
size_t spline_piece_count(const struct spline *spline);

/*
 * Piece `index`: its boxes hold the curve, and the two arcs by which LinuxCNC joins the ends of the piece in their
 * tangents. False: the curve has no tangent there, or turns back, so that there are no such arcs.
 */
bool spline_piece_find(const struct spline *spline, size_t index, struct spline_piece *piece);

#endif
