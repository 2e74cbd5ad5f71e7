/* sinumerik_comp.h - tool radius compensation (G40, G41, G42): what of a block concerns it, and its moves. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_COMP_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_COMP_H

#include "gcode/dialect/sinumerik/sinumerik_block.h"

/*
 * 840D sl, "Tool radius compensation". The engine is execute/cutter_comp, in program coordinates, which frames turn.
 * NORM leads straight to the point beside the start of the contour; with KONT, and where the program says neither,
 * every way there is proved. G450 rounds outside corners, G451 draws them out; DISC, and neither of them: all between.
 * What can fail reports why before it returns false.
 */

/* Refuses what a block under compensation cannot have: before anything else of the block. */
bool sinumerik_comp_check(struct interp *interp, const struct sinumerik_block *block);

/* Takes NORM, KONT, G450, G451, DISC, CUT2D, and switches by G40, G41 or G42. */
bool sinumerik_comp_select(struct interp *interp, const struct sinumerik_block *block);

/*
 * Refuses a move to these program coordinates that turns the tool under compensation while TRAORI is on: by the rotary
 * axes' coordinates, or on a great circle.
 */
bool sinumerik_comp_check_turn(struct interp *interp, const slot_values *target, bool on_circle, int column);

/* The program halts here (M0, M1), or has ended. */
bool sinumerik_comp_stop(struct interp *interp, int column, bool ends);

/* Does compensation lead round outside corners on a circle, as far as program and machine file say? */
bool sinumerik_comp_rounds(const struct interp *interp);

#endif
