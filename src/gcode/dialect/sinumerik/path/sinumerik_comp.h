/* sinumerik_comp.h - tool radius compensation (G40, G41, G42): its words in a block, and its moves. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_COMP_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_COMP_H

#include "gcode/dialect/sinumerik/block/sinumerik_block.h"

/*
 * 840D sl, "Tool radius compensation". The engine is execute/cutter_comp; it works in program coordinates, which
 * frames rotate. With NORM the tool moves straight to the point beside the start of the contour; with KONT, or
 * without either word, all possible paths to this point are proved. G450 rounds outside corners, G451 extends the
 * paths to their intersection; with DISC, or without either code, everything between them is proved. A function that
 * can fail reports the reason and returns false.
 */

/* Call first for each block: refuses what is not allowed under compensation. */
bool sinumerik_comp_check(struct interp *interp, const struct sinumerik_block *block);

/* Executes NORM, KONT, G450, G451, DISC and CUT2D, and G40, G41 or G42. */
bool sinumerik_comp_select(struct interp *interp, const struct sinumerik_block *block);

/*
 * Refuses a move to these program coordinates that turns the tool under compensation while TRAORI is on: by the rotary
 * axes' coordinates, or on a great circle.
 */
bool sinumerik_comp_check_turn(struct interp *interp, const slot_values *target, bool on_circle, int column);

/* Call where the program halts (M0, M1), or has ended. */
bool sinumerik_comp_stop(struct interp *interp, int column, bool ends);

/* Does compensation move around outside corners on a circle, according to the program and the machine file? */
bool sinumerik_comp_rounds(const struct interp *interp);

#endif
