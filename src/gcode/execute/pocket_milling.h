/* pocket_milling.h - general purpose pocket milling of Haas: G150, with the pocket's outline in a subprogram. */
#ifndef FIVECHECK_GCODE_EXECUTE_POCKET_MILLING_H
#define FIVECHECK_GCODE_EXECUTE_POCKET_MILLING_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Haas mill operator's manual (96-8000), "G150 General Purpose Pocket Milling": the tool moves to the hole at X and Y
 * and mills, from R down to Z, the inside of the closed outline that the subprogram P describes with G1, G2 and G3; G41
 * or G42 in the block keeps the tool inside the outline. The control chooses the path in the pocket. Therefore the
 * whole box of the outline is proved, from the start position and R down to Z, and afterwards the tool may be anywhere
 * in the box until X, Y and Z are commanded. The dialect calls the subprogram between pocket_milling_begin and
 * pocket_milling_finish.
 */

/* Refuses what is not allowed in the outline or the block after it, and removes G41 from the block. False: reported. */
bool pocket_milling_start_block(struct interp *interp);

/* Carries out G150: from now on moves are the outline (pocket_outline.h). False: reported. */
bool pocket_milling_begin(struct interp *interp);

/* Call at the end of the outline: sends all possible moves. False: reported, or the sink wants no more. */
bool pocket_milling_finish(struct interp *interp);

#endif
