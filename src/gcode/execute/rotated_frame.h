/* rotated_frame.h - conversion of programmed to controller positions in turned coordinates (G68, G68.2), and back. */
#ifndef FIVECHECK_GCODE_EXECUTE_ROTATED_FRAME_H
#define FIVECHECK_GCODE_EXECUTE_ROTATED_FRAME_H

#include "gcode/state.h"
#include "gcode/text/block.h"
#include "geom/xform.h"

/*
 * "Straight" positions are the program's coordinates + state->offset. Without a frame they are the controller's
 * positions; with a frame
 *     position = offset + origin + turn (straight - offset)
 * for X Y Z, while all other axes are unchanged. If the frame also turns the tool's length L along Z, turn L - L is
 * added.
 */
slot_values rotated_frame_straight(const struct state *state);
slot_values rotated_frame_position(const struct state *state, const slot_values *straight);

/* The controller's coordinates of a point and of a direction given in straight coordinates. */
vec3 rotated_frame_point(const struct state *state, vec3 straight);
vec3 rotated_frame_direction(const struct state *state, vec3 direction);

/* The inverse: the straight coordinates of a point and of a direction of the controller. */
vec3 rotated_frame_straight_point(const struct state *state, vec3 position);
vec3 rotated_frame_straight_direction(const struct state *state, vec3 direction);

/* The controller's direction (unit vector) of the axis of a right-handed turn about a straight direction. */
vec3 rotated_frame_normal(const struct state *state, vec3 normal);

/*
 * Marks the coordinates that a change of the frame by this code has changed: *before are the straight positions before.
 */
void rotated_frame_mark_unsure(struct state *state, const slot_values *before, int code);

/* The part of the block that is not possible in scaled or mirrored coordinates (in words), and its column; or NULL. */
const char *rotated_frame_conflict(const struct block *block, int *column);

#endif
