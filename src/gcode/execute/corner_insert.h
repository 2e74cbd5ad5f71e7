/* corner_insert.h - ",C" and ",R": a chamfer or a rounding between the block that has it and the next one. */
#ifndef FIVECHECK_GCODE_EXECUTE_CORNER_INSERT_H
#define FIVECHECK_GCODE_EXECUTE_CORNER_INSERT_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Fanuc B-64484EN, "Optional Chamfering and Corner R"; Haas mill operator's manual, "Corner Rounding and
 * Chamfering". The block that has the word waits, as if the program were at its end already, until the next block
 * says where it goes on. What can fail reports why before it returns false.
 */

/* Refuses what may not stand in or behind a block with a corner: before anything else of the block. */
bool corner_insert_start_block(struct interp *interp);

/* A move in the plane that is ready to be made, from where the program is. */
struct corner_move {
	const slot_values *target; /* straight */
	const struct canon_move *move; /* its kind and feed */
	bool is_arc;
	struct plane_point centre;
};

/*
 * Makes the block that waits and the corner behind it, so that the program stands where the corner ends. Then, if the
 * block in hand has a corner, takes it to wait: *waits is true, and its move is not to be made.
 */
bool corner_insert_pass(struct interp *interp, const struct corner_move *next, bool *waits);

/* Is there anything for corner_insert_pass to do? */
static inline bool corner_insert_concerns(const struct interp *interp)
{
	return interp->corner.on || interp->block.corner != '\0';
}

/* Has the block in hand been taken to wait? Then its end is told later. */
bool corner_insert_keeps_block(struct interp *interp);

/* The block has been carried out, or the program has ended: nothing waits any longer. */
bool corner_insert_end_block(struct interp *interp);

#endif
