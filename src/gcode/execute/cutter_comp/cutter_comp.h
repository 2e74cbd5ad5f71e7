/* cutter_comp.h - cutter radius compensation (G40, G41, G42): moves beside the programmed path. */
#ifndef FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_CUTTER_COMP_H
#define FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_CUTTER_COMP_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * LinuxCNC's manual, "Cutter Compensation", and its 2.9 interpreter: the first move goes to the side of the path,
 * outside corners are rounded, and at inside corners the two paths end at their intersection. The end of a move is
 * known only after the next move was read, so moves and the ends of their blocks wait in comp_queue. While compensation
 * is on, state.position is the programmed point. comp_codes.h has the codes, comp_lookahead.h the controls that look
 * ahead.
 */

/* Is compensation on? Then cutter_comp_line and cutter_comp_arc make the moves. */
static inline bool cutter_comp_is_on(const struct interp *interp)
{
	return interp->comp.side != 0 && interp->comp.radius > 0;
}

/* Move to the programmed position; an arc has its programmed centre and its full turns, from 1. */
bool cutter_comp_line(struct interp *interp, const slot_values *target, struct canon_move *move);
bool cutter_comp_arc(struct interp *interp, const slot_values *target, struct plane_point centre, int turns,
		     struct canon_move *move);

/* Sends the end of the block to the sink, after those of its moves that wait. */
bool cutter_comp_end_block(struct interp *interp);

/* Call where the program stops: sends the waiting moves with their present ends. */
bool cutter_comp_stop(struct interp *interp);

#endif
