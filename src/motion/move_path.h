/* move_path.h - the path of a canonical move from the present position of the axes. */
#ifndef FIVECHECK_MOTION_MOVE_PATH_H
#define FIVECHECK_MOTION_MOVE_PATH_H

#include <stdbool.h>

#include "gcode/canon.h"
#include "machine/machine.h"
#include "motion/path.h"

/* The start of a move. Borrows everything. */
struct move_start {
	const struct machine *machine;
	const struct tcp *tcp;	/* of moves under TCP; the path borrows it */
	const axis_values *position;	/* of the machine's axes */
	/* the same position as the controller sees it under TCP; NULL: to be computed */
	const axis_values *controller;
};

/*
 * Fills every field of the path but `seconds`, and `arc` only for an arc, because the cost of a block counts. If the
 * axes move independently under TCP, *guided receives start and end as the controller sees them.
 */
void move_path_set(struct path *path, const struct move_start *from, const struct canon_move *move,
		   struct path *guided);

/* Does an axis have another position at the end of the path than at its start? */
bool move_path_moves(const struct path *path);

/* The number of axes that move. */
int move_path_axes(const struct path *path);

#endif
