/* sinumerik_soft.h - soft approach to a contour (G147, G247, G347) and retraction from it (G148, G248, G348). */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_SOFT_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_SOFT_H

#include "gcode/dialect/sinumerik/block/sinumerik_block.h"
#include "gcode/dialect/sinumerik/path/sinumerik_circle.h"

/*
 * 840D sl, basic functions W1, "Soft approach and retraction (SAR)": from P0 to P1 beside the contour, down to P2 above
 * it, with G341 also to P3 at its height, and to P4 on the contour by a line, a quadrant or a semicircle that touches
 * it; with G340 this last path goes down from P2. The retraction is the same the other way round. Tool radius
 * compensation treats the path as if it were programmed. Functions report the reason before they return false.
 */

/* Call before the block's own modes are set: the speed of the block before it is that of a part of the motion. */
void sinumerik_soft_note(struct interp *interp, const struct sinumerik_block *block);

/* Reads G140 to G143, G340 and G341, and refuses words that belong to another code. */
bool sinumerik_soft_select(struct interp *interp, const struct sinumerik_block *block);

/* The motion of a block that has such a code. An approach waits for the next path. */
bool sinumerik_soft_run(struct interp *interp, const struct sinumerik_block *block);

/* Does an approach wait? Then call sinumerik_soft_pass before the next path. */
static inline bool sinumerik_soft_waits(const struct interp *interp)
{
	return sinumerik_of(interp)->soft.waits;
}

/*
 * Carries out the waiting approach before a path to `target` in program coordinates. *taken: the path only gave the
 * end of the approach, which waits further.
 */
bool sinumerik_soft_pass(struct interp *interp, const slot_values *target, const struct canon_move *move,
			 const struct sinumerik_circle *circle, bool *taken);

/* Does the current block wait? Then its end is sent to the sink later. */
bool sinumerik_soft_keeps_block(struct interp *interp);

/* Refuses a block that was no path while an approach waited. */
bool sinumerik_soft_end_block(struct interp *interp);

void sinumerik_soft_release(struct sinumerik *sinumerik);

#endif
