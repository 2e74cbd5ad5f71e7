/* rotated_frame.h - from programmed to controller positions in turned coordinates (G68, G68.2), and back. */
#ifndef FIVECHECK_GCODE_EXECUTE_ROTATED_FRAME_H
#define FIVECHECK_GCODE_EXECUTE_ROTATED_FRAME_H

#include "gcode/state.h"
#include "gcode/text/block.h"
#include "geom/xform.h"

/*
 * "Straight" positions are the program's coordinates + state->offset. While no
 * frame is in force they are the controller's positions; else
 *     position = offset + origin + turn (straight - offset)
 * for X Y Z, and the same for every other axis. Where the frame turns the tool's length L along Z, too, turn L - L is
 * added.
 */
slot_values rotated_frame_straight(const struct state *state);
slot_values rotated_frame_position(const struct state *state, const slot_values *straight);

/* The controller's coordinates of a point and of a direction of X Y Z that are given in straight coordinates. */
vec3 rotated_frame_point(const struct state *state, vec3 straight);
vec3 rotated_frame_direction(const struct state *state, vec3 direction);

/* Back: the straight coordinates of a point and of a direction of the controller. */
vec3 rotated_frame_straight_point(const struct state *state, vec3 position);
vec3 rotated_frame_straight_direction(const struct state *state, vec3 direction);

/* The controller's direction of the axis (unit) about which a right-handed turn of straight coordinates goes. */
vec3 rotated_frame_normal(const struct state *state, vec3 normal);

/*
 * Marks the coordinates that a change of the frame by this code has changed: *before are the straight ones before it.
 */
void rotated_frame_mark_unsure(struct state *state, const slot_values *before, int code);

/* What of the block does not go with coordinates that are scaled or mirrored, and its column; NULL: nothing. */
const char *rotated_frame_conflict(const struct block *block, int *column);

#endif
