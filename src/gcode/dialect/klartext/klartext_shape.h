/* klartext_shape.h - what the shapes of milling cycles have in common: sizes, places, turns, and the tool's radius. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_SHAPE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_SHAPE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_region.h"

/*
 * The length of Q<q>, mm, which is a size: the region of a negative one would shrink to its centre. False: reported.
 */
bool klartext_shape_size(const struct klartext_call_of *call, int q, double *value);

/* A box of these half sides, mm, turned by an angle: the box about it along X and Y. */
void klartext_shape_turn(struct klartext_region *region, double along, double across, double degrees);

/* Where the centre lies from where the tool stands, as Q367 says, in the units of `places`. False: reported. */
bool klartext_shape_place(const struct klartext_call_of *call, const double places[5][2], double way[2]);

/* Moves the centre by these lengths, mm, along X and Y turned by an angle. */
void klartext_shape_shift(struct klartext_region *region, double x, double y, double degrees);

/* The centre is Q216, Q217. False: reported. */
bool klartext_shape_middle(const struct klartext_call_of *call, struct klartext_region *region);

/* The region of the tool's centre within a circle, both mm. */
void klartext_shape_disc(struct klartext_region *region, double diameter, double radius);

/* The tool's radius, mm, as far as it is known: the region within a shape is the greater without. */
double klartext_shape_tool_radius(const struct klartext_call_of *call);

/* The same for a shape that the tool stays outside of: the radius has to be known. False: reported. */
bool klartext_shape_need_radius(const struct klartext_call_of *call, double *radius);

#endif
