/* klartext_free_ahead.h - the tangential FK elements behind the current block, which can determine its end. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_FREE_AHEAD_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_FREE_AHEAD_H

#include <stdbool.h>

#include "gcode/state.h"
#include "geom/vec3.h"

/* A circle with its direction of rotation, mm. */
struct klartext_free_circle {
	vec3 centre;
	double radius;
	int turn; /* 1: counter-clockwise, -1: clockwise */
};

/* FCT with centre, radius and direction of rotation comes next, or after an FLT without words. */
struct klartext_free_ahead {
	bool line; /* FLT comes first */
	struct klartext_free_circle circle;
};

/* Reads the next blocks without carrying them out. False: other blocks follow; nothing is reported. */
bool klartext_free_ahead_read(struct interp *interp, struct klartext_free_ahead *ahead);

#endif
