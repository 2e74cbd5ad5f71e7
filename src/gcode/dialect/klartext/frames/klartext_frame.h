/* klartext_frame.h - conversion of programmed coordinates to positions, and back. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_FRAMES_KLARTEXT_FRAME_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_FRAMES_KLARTEXT_FRAME_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"

/* Recomputes the derived data of the frame, and updates the interpreter's state. */
void klartext_frame_update(struct interp *interp);

/* The position of a programmed point, and back: X, Y, Z in mm. */
vec3 klartext_frame_position(const struct interp *interp, vec3 point);
vec3 klartext_frame_point(const struct interp *interp);

/* The same for any point, without the tool's length: its place on the machine's table, and back. */
vec3 klartext_frame_place_of(const struct interp *interp, vec3 point);
vec3 klartext_frame_point_at(const struct interp *interp, vec3 place);

/*
 * Increments are relative to the last programmed position. If coordinates have changed since, or the control has moved
 * the axis itself, increments_after_shift="stay" of the machine file means that they are relative to the present
 * position of the axis. False: this is not known for the axis, which was reported.
 */
bool klartext_frame_check_increment(struct interp *interp, int slot, int column);

/* Converts a direction from programmed coordinates to positions; without scaling. */
vec3 klartext_frame_direction(const struct interp *interp, vec3 direction);

/*
 * Converts a box of these half sides from programmed coordinates to positions, without scaling; and the half sides of
 * the enclosing box along the axes of positions.
 */
struct parallel_box klartext_frame_turned_box(const struct interp *interp, const double half[3]);
vec3 klartext_frame_box(const struct interp *interp, const double half[3]);

/*
 * TNC 640 user's manual, preset table: a machine parameter (presetToAlignAxis) decides whether the kinematics includes
 * the offset of a rotary axis. Is the zero of rotary axes known for M128, TCPM and PLANE? False: reported.
 */
bool klartext_frame_check_zero(struct interp *interp, int column);

/*
 * Is the datum shift of these axes, bits 1 << slot, known? It is not known if a shift in a tilted plane named an axis
 * that an earlier shift also moves, and the plane has ended since. False: reported.
 */
bool klartext_frame_check_shift(const struct interp *interp, unsigned axes, int column);

/* Has SCALING (CYCL DEF 11, 26) factors other than 1? */
bool klartext_frame_is_scaled(const struct interp *interp);

/* The place of the last line of a definition, or of an earlier line, whose text is no longer available. */
struct line_place klartext_frame_place(const struct interp *interp, long line);

/* Is any inner transformation active: mirror, rotation, scaling, a shift after the tilting? */
bool klartext_frame_is_inner(const struct klartext_frame *frame);

#endif
