/* klartext_shape.h - common functions for the shapes of milling cycles: sizes, places, turns, the tool's radius. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_SHAPE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_SHAPE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/cycles/klartext_region.h"

/*
 * The size in Q<q>, mm. A negative size is refused, because its region would shrink to its centre. False: reported.
 */
bool klartext_shape_size(const struct klartext_call_of *call, int q, double *value);

/* Sets the region to the box along X and Y that encloses a turned box of these half sides, mm. */
void klartext_shape_turn(struct klartext_region *region, double along, double across, double degrees);

/* The centre relative to the present position, according to Q367, in the units of `places`. False: reported. */
bool klartext_shape_place(const struct klartext_call_of *call, const double places[5][2], double way[2]);

/* Moves the centre by these lengths, mm, along X and Y turned by an angle. */
void klartext_shape_shift(struct klartext_region *region, double x, double y, double degrees);

/* The centre is Q216, Q217. False: reported. */
bool klartext_shape_middle(const struct klartext_call_of *call, struct klartext_region *region);

/* The region of the tool's centre within a circle, both mm. */
void klartext_shape_disc(struct klartext_region *region, double diameter, double radius);

/* The tool's radius, mm, or 0 if not known: without it the region inside a shape is larger. */
double klartext_shape_tool_radius(const struct klartext_call_of *call);

/* The same for a shape whose outside is milled: the radius must be known. False: reported. */
bool klartext_shape_need_radius(const struct klartext_call_of *call, double *radius);

#endif
