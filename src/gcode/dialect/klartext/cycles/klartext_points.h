/* klartext_points.h - the points of a pattern: single points, rows of points, points on a circle. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_POINTS_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_POINTS_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"

/* Rows of points. */
struct klartext_grid {
	vec3 start;
	double spacing[2]; /* along a row, and between rows */
	double angle[2]; /* degrees: of a row, and of the step to the next row */
	int count[2]; /* points of a row, and rows */
	bool zigzag; /* every second row runs backwards */
	bool frame; /* only the points at the edge */
};

/* Start without points; and add a point, programmed coordinates in mm. False: reported at the column. */
void klartext_points_begin(struct interp *interp);
bool klartext_points_add(struct interp *interp, int column, vec3 point);

/* Add all points of the rows; and `count` points on a circle, angles in degrees. False: the same. */
bool klartext_points_add_grid(struct interp *interp, int column, const struct klartext_grid *grid);
bool klartext_points_add_circle(struct interp *interp, int column, vec3 centre, double diameter, double start,
				double step, int count);

#endif
