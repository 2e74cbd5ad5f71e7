/* klartext_frame.h - from programmed coordinates to positions, and the cycles that change the way there. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_FRAME_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_FRAME_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_state.h"

/* Recomputes what the frame is made of, and tells the interpreter whether there is one. */
void klartext_frame_update(struct interp *interp);

/* The position of a programmed point, and back: X, Y, Z in mm. */
vec3 klartext_frame_position(const struct interp *interp, vec3 point);
vec3 klartext_frame_point(const struct interp *interp);

/* The same, of any point and without the tool's length: where it lies on the machine's table, and back. */
vec3 klartext_frame_place_of(const struct interp *interp, vec3 point);
vec3 klartext_frame_point_at(const struct interp *interp, vec3 place);

/*
 * Increments count from the position that was programmed last. Where coordinates have changed since, or the control has
 * moved the axis by itself, increments_after_shift="stay" of the machine file says that they count from where the axis
 * stands. False: it is not known for this axis, which was reported.
 */
bool klartext_frame_check_increment(struct interp *interp, int slot, int column);

/* A direction of programmed coordinates as one of positions; no scaling. */
vec3 klartext_frame_direction(const struct interp *interp, vec3 direction);

/*
 * A box of these half sides in programmed coordinates, no scaling: as it lies in positions, and the half sides of the
 * box along their axes about it.
 */
struct parallel_box klartext_frame_turned_box(const struct interp *interp, const double half[3]);
vec3 klartext_frame_box(const struct interp *interp, const double half[3]);

/*
 * TNC 640 user's manual, preset table: by a machine parameter (presetToAlignAxis) the offset of a rotary axis counts in
 * the kinematics or not. Is it known from where M128, TCPM and PLANE count rotary axes? False: reported.
 */
bool klartext_frame_check_zero(struct interp *interp, int column);

/*
 * Is the datum shift of these axes, bits 1 << slot, known? It is not where a shift in a tilted plane has named an axis
 * that one from before the plane shifts, and the plane has ended since. False: reported.
 */
bool klartext_frame_check_shift(const struct interp *interp, unsigned axes, int column);

/* Has SCALING (CYCL DEF 11, 26) factors other than 1? */
bool klartext_frame_is_scaled(const struct interp *interp);

/* The last line of a definition, or an earlier one, whose text is no longer there. */
struct line_place klartext_frame_place(const struct interp *interp, long line);

/* Is anything of the inner coordinates in force: mirror, rotation, scaling, a shift behind the tilting? */
bool klartext_frame_is_inner(const struct klartext_frame *frame);

#endif
