/* move_path.h - the path that a canonical move takes from where the axes stand. */
#ifndef FIVECHECK_MOTION_MOVE_PATH_H
#define FIVECHECK_MOTION_MOVE_PATH_H

#include <stdbool.h>

#include "gcode/canon.h"
#include "machine/machine.h"
#include "motion/path.h"

/* Where a move begins. All of it is borrowed. */
struct move_start {
	const struct machine *machine;
	const struct tcp *tcp;	/* of moves under TCP; the path borrows it */
	const axis_values *position;	/* of the machine's axes */
	/* the same position as the controller means it under TCP; NULL: to be computed */
	const axis_values *controller;
};

/*
 * Fills the path's every field but `seconds`, and `arc` only of an arc: a block's cost counts. Where the axes go their
 * own ways under TCP, *guided receives start and end as the controller means them.
 */
void move_path_set(struct path *path, const struct move_start *from, const struct canon_move *move,
		   struct path *guided);

/* Has an axis another position at the path's end than at its start? */
bool move_path_moves(const struct path *path);

#endif
