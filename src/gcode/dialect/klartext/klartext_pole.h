/* klartext_pole.h - the plane and the pole that CC has given, and polar coordinates. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_POLE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_POLE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_move.h"
#include "gcode/execute/arc.h"

/* mm; slot: X, Y or Z. */
double klartext_pole_coordinate(vec3 v, int slot);
void klartext_pole_set_coordinate(vec3 *v, int slot, double value);

/* The plane across Z is XY, across Y ZX, across X YZ: a point in it, and a point with these coordinates in it. */
struct plane_point klartext_pole_flat(vec3 v, int across);
void klartext_pole_put(vec3 *v, int across, struct plane_point point);

/* Do these coordinates of CC, bits 1 << slot, lie where they lay when it was given? False: reported. */
bool klartext_pole_check(struct interp *interp, unsigned axes, int column);

/* The pole. False: CC has not given it, or coordinates have changed since, which was reported at the column. */
bool klartext_pole_find(struct interp *interp, int column, struct plane_point *pole);

/* The point that PR and PA name from CC on; left out or increments: from the start of the path. False: reported. */
bool klartext_pole_point(struct interp *interp, const struct klartext_words *words, const struct klartext_path *path,
			 struct klartext_target *target);

#endif
