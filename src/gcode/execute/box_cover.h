/* box_cover.h - straight lines that together cover the volume that a box sweeps on a straight path. */
#ifndef FIVECHECK_GCODE_EXECUTE_BOX_COVER_H
#define FIVECHECK_GCODE_EXECUTE_BOX_COVER_H

#include <stdbool.h>

#include "geom/vec3.h"

/* A box that moves on a straight path: mm. */
struct box_way {
	vec3 start, way;	/* of its centre: the start point and the displacement */
	vec3 half[3];	/* from the centre to the middles of three faces: at right angles, or 0 */
};

/* All places whose distance from the line is at most `spread` along X, Y and Z. */
struct cover_line {
	vec3 from, to, spread;
};

/* False: stop. */
typedef bool (*cover_take)(void *context, const struct cover_line *line);

/*
 * Covers the swept volume of the box: every place of the volume is in the spread of a line. Each line is inside the
 * volume, and so is the segment from the end of a line to the start of the next one. The spread of a line, even if it
 * is taken as a ball, leaves the volume by at most `beside` mm: lines near the surface have a small spread, lines deep
 * inside have a large one. If the box moves neither along its sides nor in a plane of two of them, or if the box is
 * very large, `beside` is increased to limit the number of lines. False: `take` has stopped.
 */
bool box_cover(const struct box_way *box, double beside, cover_take take, void *context);

#endif
