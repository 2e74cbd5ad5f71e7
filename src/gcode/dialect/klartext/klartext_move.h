/* klartext_move.h - positioning blocks: where their words lead, what their M-functions do, and the moves they make. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_MOVE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_MOVE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_words.h"

/* Where a block leads: the programmed point in mm, and positions of the other axes. */
struct klartext_target {
	vec3 point;
	slot_values others; /* of all slots but X, Y and Z */
	bool turns; /* a rotary axis is named */
};

/* The target of the block's axis words. False: reported. */
bool klartext_move_target(struct interp *interp, const struct klartext_words *words, struct klartext_target *target);

/* The feed of the block's move; a rapid where *rapid comes back true. False: reported. */
bool klartext_move_feed(struct interp *interp, const struct klartext_words *words, bool *rapid,
			struct canon_feed *feed);

/* The direction at the start and at the end of a path, unit; false: it has none. */
bool klartext_move_start_direction(const struct klartext_path *path, vec3 *direction);
bool klartext_move_end_direction(const struct klartext_path *path, vec3 *direction);

/* The program counts as being at this programmed point; nothing is sent. */
void klartext_move_put(struct interp *interp, vec3 point);

/* Linear axes move behind PLANE ... STAY, and the rotary axes do not stand where it needs them: reports that; false. */
bool klartext_move_refuse_waiting(struct interp *interp, int column);

/* May linear axes move now? Not between PLANE ... STAY and its rotary axes. False: reported. */
bool klartext_move_check(struct interp *interp, const struct klartext_target *target, int column);

/* Do the rotary axes stand where the tilted plane needs them? Whole turns do not matter. */
bool klartext_move_in_plane(const struct interp *interp, const slot_values *others);

/*
 * Switches M128 off. In a tilted plane the coordinates are those of the plane again, but if the rotary axes have
 * left it linear axes wait until they are back. False: reported at the column.
 */
bool klartext_move_end_tcp(struct interp *interp, int column);

/* Sends a straight move to the target. False: the sink wants no more, or reported. */
bool klartext_move_line(struct interp *interp, const struct klartext_target *target, bool rapid,
			const struct canon_feed *feed);

/* The same with a move of its own, whose rotary axes may be beside their straight way (canon_move.turn_spread). */
bool klartext_move_turning(struct interp *interp, const struct klartext_target *target, struct canon_move *move);

/* The same of a path that is open: anywhere in the box about the straight line. */
bool klartext_move_within(struct interp *interp, const struct klartext_target *target,
			  const struct klartext_path *path);

/* May an arc be made with the scaling in force? False: reported. */
bool klartext_move_check_arc(struct interp *interp, const struct klartext_path *path, int column);

/* Sends an arc in programmed coordinates. */
bool klartext_move_arc(struct interp *interp, const struct klartext_target *target, const struct klartext_path *arc);

#endif
