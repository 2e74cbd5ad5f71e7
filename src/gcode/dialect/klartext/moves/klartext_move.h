/* klartext_move.h - positioning blocks: the targets of their words, their feeds, and their moves. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_MOVES_KLARTEXT_MOVE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_MOVES_KLARTEXT_MOVE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/words/klartext_words.h"

/* The end of a block: the programmed point in mm, and positions of the other axes. */
struct klartext_target {
	vec3 point;
	slot_values others; /* of all slots but X, Y and Z */
	bool turns; /* a rotary axis is named */
};

/* The target of the block's axis words. False: reported. */
bool klartext_move_target(struct interp *interp, const struct klartext_words *words, struct klartext_target *target);

/* The feed of the block's move; *rapid: the move is a rapid. False: reported. */
bool klartext_move_feed(struct interp *interp, const struct klartext_words *words, bool *rapid,
			struct canon_feed *feed);

/* The unit direction at the start and at the end of a path; false: it has none. */
bool klartext_move_start_direction(const struct klartext_path *path, vec3 *direction);
bool klartext_move_end_direction(const struct klartext_path *path, vec3 *direction);

/* Sets the position to this programmed point, without a move. */
void klartext_move_put(struct interp *interp, vec3 point);

/* Reports that linear axes move after PLANE ... STAY before the rotary axes are at its positions; false. */
bool klartext_move_refuse_waiting(struct interp *interp, int column);

/* May linear axes move now? Not between PLANE ... STAY and the move of its rotary axes. False: reported. */
bool klartext_move_check(struct interp *interp, const struct klartext_target *target, int column);

/* Are the rotary axes at the positions of the tilted plane? Full turns do not matter. */
bool klartext_move_in_plane(const struct interp *interp, const slot_values *others);

/*
 * Switches M128 off. In a tilted plane the coordinates are those of the plane again; if the rotary axes have left the
 * positions of the plane, linear axes must wait until they return. False: reported at the column.
 */
bool klartext_move_end_tcp(struct interp *interp, int column);

/* Sends a straight move to the target. False: the sink wants no more, or reported. */
bool klartext_move_line(struct interp *interp, const struct klartext_target *target, bool rapid,
			const struct canon_feed *feed);

/* The same with the caller's move, whose rotary axes may deviate from linear interpolation (turn_spread). */
bool klartext_move_turning(struct interp *interp, const struct klartext_target *target, struct canon_move *move);

/* The same for a path that is not known exactly: anywhere in the box about the straight line. */
bool klartext_move_within(struct interp *interp, const struct klartext_target *target,
			  const struct klartext_path *path);

/* Is an arc possible with the active scaling? False: reported. */
bool klartext_move_check_arc(struct interp *interp, const struct klartext_path *path, int column);

/* Sends an arc in programmed coordinates. */
bool klartext_move_arc(struct interp *interp, const struct klartext_target *target, const struct klartext_path *arc);

#endif
