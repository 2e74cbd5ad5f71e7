/* corner_insert.h - ",C" and ",R": a chamfer or a rounding between the block with the word and the next block. */
#ifndef FIVECHECK_GCODE_EXECUTE_CORNER_INSERT_H
#define FIVECHECK_GCODE_EXECUTE_CORNER_INSERT_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Fanuc B-64484EN, "Optional Chamfering and Corner R"; Haas mill operator's manual, "Corner Rounding and Chamfering".
 * The block with the word waits until the next block gives the direction after the corner; meanwhile the state has the
 * end of the waiting block. Functions that can fail report the fault before they return false.
 */

/* Call first for each block: refuses what is not allowed in or after a block with a corner. */
bool corner_insert_start_block(struct interp *interp);

/* A move in the plane that is ready to be made, from the present programmed position. */
struct corner_move {
	const slot_values *target; /* straight position */
	const struct canon_move *move; /* only its kind and feed */
	bool is_arc;
	struct plane_point centre;
};

/*
 * Makes the moves of the block that waits and of its corner; the programmed position is then the end of the corner. If
 * the current block has a corner, it waits from now on: *waits is true, and its move must not be made.
 */
bool corner_insert_pass(struct interp *interp, const struct corner_move *next, bool *waits);

/* Must corner_insert_pass be called? */
static inline bool corner_insert_concerns(const struct interp *interp)
{
	return interp->corner.on || interp->block.corner != '\0';
}

/* Does the current block wait? Then its end is sent to the sink later. */
bool corner_insert_keeps_block(struct interp *interp);

/* Call after the block has been carried out, or at the end of the program: no block waits any longer. */
bool corner_insert_end_block(struct interp *interp);

#endif
