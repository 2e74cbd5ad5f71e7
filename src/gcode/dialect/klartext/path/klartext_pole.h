/* klartext_pole.h - the plane and the pole of CC, and polar coordinates. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_POLE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_POLE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/moves/klartext_move.h"
#include "gcode/execute/arc.h"

/* mm; slot: X, Y or Z. */
double klartext_pole_coordinate(vec3 v, int slot);
void klartext_pole_set_coordinate(vec3 *v, int slot, double value);

/* The plane perpendicular to Z is XY, to Y ZX, to X YZ: converts a point to the plane, and back. */
struct plane_point klartext_pole_flat(vec3 v, int across);
void klartext_pole_put(vec3 *v, int across, struct plane_point point);

/* Are the places of these coordinates of CC, bits 1 << slot, unchanged since CC was read? False: reported. */
bool klartext_pole_check(struct interp *interp, unsigned axes, int column);

/* The pole. False: no CC was read, or coordinates have changed since, which was reported at the column. */
bool klartext_pole_find(struct interp *interp, int column, struct plane_point *pole);

/* The point of PR and PA about CC; omitted or incremental: relative to the start of the path. False: reported. */
bool klartext_pole_point(struct interp *interp, const struct klartext_words *words, const struct klartext_path *path,
			 struct klartext_target *target);

#endif
