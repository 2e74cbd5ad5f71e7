/* pocket_milling.h - general purpose pocket milling of Haas: G150, with a subprogram that has the pocket's outline. */
#ifndef FIVECHECK_GCODE_EXECUTE_POCKET_MILLING_H
#define FIVECHECK_GCODE_EXECUTE_POCKET_MILLING_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Haas mill operator's manual (96-8000), "G150 General Purpose Pocket Milling": the tool goes to the hole at X and Y
 * and mills, from R down to Z, the inside of the closed outline that the subprogram P has in G1, G2 and G3; G41 or G42
 * in the block keeps the tool inside it. How it goes there is the control's choice: the box of the outline is proved,
 * from where it comes from and R down to Z, and the tool may stay anywhere in it until X, Y and Z are commanded. The
 * dialect calls the subprogram between pocket_milling_begin and pocket_milling_finish.
 */

/* Refuses what the outline or the block behind it cannot have, and takes G41 out of the block. False: reported. */
bool pocket_milling_start_block(struct interp *interp);

/* Carries out G150: from here on moves are the outline (pocket_outline.h). False: reported. */
bool pocket_milling_begin(struct interp *interp);

/* The outline is complete: sends what the tool may do. False: reported, or the sink wants no more. */
bool pocket_milling_finish(struct interp *interp);

#endif
