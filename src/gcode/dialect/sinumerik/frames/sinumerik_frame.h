/* sinumerik_frame.h - program coordinates and positions: frames (TRANS, ROT, SCALE, MIRROR) and the work offset. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_FRAMES_SINUMERIK_FRAME_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_FRAMES_SINUMERIK_FRAME_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/*
 * position = offset + shift + matrix p, for X Y Z and the program coordinates p. `offset` is the sum of the active
 * work offset and tool length; matrix and shift are those of the frames. If the frames only shift, all of it is put
 * into state.shift, else into state.frame (rotated_frame.h), whose matrix may mirror and scale here.
 */

/* The program coordinates of the present position, mm and degrees. */
const slot_values *sinumerik_frame_place(struct interp *interp);

/* The straight position (rotated_frame.h) of program coordinates. */
slot_values sinumerik_frame_straight(const struct interp *interp, const slot_values *place);

/* Call after the position was changed in another way than by program coordinates. */
void sinumerik_frame_moved(struct interp *interp);

/*
 * Call after a change of frames, offsets or lengths, and call sinumerik_frame_place before the change: an increment
 * may be relative to the program coordinates before it. False: reported at the column.
 */
bool sinumerik_frame_changed(struct interp *interp, int column);

/* Matrix and shift of all active frames together. */
struct sinumerik_frame sinumerik_frame_total(const struct sinumerik *sinumerik);

/* The frame that applies `inner` first, and then `outer`. */
struct sinumerik_frame sinumerik_frame_chain(const struct sinumerik_frame *outer, const struct sinumerik_frame *inner);

/* The scale factor of a frame. False: it depends on the direction. */
bool sinumerik_frame_scale(const mat3 *matrix, double *factor);

/*
 * The same for the plane perpendicular to one of X, Y and Z, if the frame keeps this axis perpendicular to it: a
 * circle in the plane stays a circle, whatever the scale of its height is.
 */
bool sinumerik_frame_scale_plane(const mat3 *matrix, enum axis_slot across, double *factor);

/* Do the active frames change lengths in a direction (SCALE)? Rotation and mirroring do not. */
bool sinumerik_frame_resizes(const struct interp *interp);

struct sinumerik_frame sinumerik_frame_none(void);

/*
 * The matrix of a plane by two solid angles in degrees, about the two axes other than `third` (a slot). Each angle
 * rotates the other axis about its own axis into the plane, and the first axis stays in its old plane with the third.
 * False: there is no such plane.
 */
bool sinumerik_frame_solid(int third, vec3 angles, mat3 *matrix);

/* TRANS, ATRANS, ROT, AROT, SCALE, ASCALE, MIRROR, AMIRROR, ROTS, AROTS; G58, G59. */
enum sinumerik_frame_code {
	SINUMERIK_TRANS, SINUMERIK_ROT, SINUMERIK_SCALE, SINUMERIK_MIRROR, SINUMERIK_SOLID, SINUMERIK_AXIAL
};

/* The words of such a statement. */
struct sinumerik_frame_words {
	enum sinumerik_frame_code code;
	bool added;	/* the A... form: added to the active frame; G59 */
	bool has[SLOT_COUNT];
	double value[SLOT_COUNT];	/* TRANS: mm and degrees */
	bool has_plane_angle;	/* RPL */
	double plane_angle;	/* degrees */
	int column;
};

/* Executes such a statement. False: reported. */
bool sinumerik_frame_set(struct interp *interp, const struct sinumerik_frame_words *words);

#endif
