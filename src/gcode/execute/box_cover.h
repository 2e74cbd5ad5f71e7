/* box_cover.h - straight lines that together cover all that a box passes on a straight way. */
#ifndef FIVECHECK_GCODE_EXECUTE_BOX_COVER_H
#define FIVECHECK_GCODE_EXECUTE_BOX_COVER_H

#include <stdbool.h>

#include "geom/vec3.h"

/* A box goes from a place to another one: mm. */
struct box_way {
	vec3 start, way;	/* of its centre */
	vec3 half[3];	/* from the centre to the middles of three faces: at right angles, or 0 */
};

/* All places that are at most `spread` beside the line along X, Y and Z. */
struct cover_line {
	vec3 from, to, spread;
};

/* False: no more lines. */
typedef bool (*cover_take)(void *context, const struct cover_line *line);

/*
 * Every place that the box passes is in the spread of a line. Each line lies in what the box passes, and so does the
 * way from the end of one to the start of the next. No line has more in its spread than reaches `beside` mm out of it,
 * even where the spread is taken to be a ball: lines near the surface are narrow, those deep inside are wide. Of a box
 * that goes neither along its sides nor in their plane this is true for a larger `beside`, which keeps the number of
 * lines in bounds; so it is for a very large box. False: `take` wants no more.
 */
bool box_cover(const struct box_way *box, double beside, cover_take take, void *context);

#endif
