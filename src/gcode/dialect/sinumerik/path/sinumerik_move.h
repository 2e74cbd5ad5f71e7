/* sinumerik_move.h - the motion of a block: lines, circles, helices. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_MOVE_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_MOVE_H

#include "gcode/dialect/sinumerik/block/sinumerik_block.h"

/*
 * Executes the motion that the words of the block command. False: reported, or the sink wants no more. *moved: the
 * block has axis words in program coordinates, so a modal call follows.
 */
bool sinumerik_move_run(struct interp *interp, const struct sinumerik_block *block, bool *moved);

/* G63 of the block. False: as above. */
bool sinumerik_move_tap(struct interp *interp, const struct sinumerik_block *block);

/* Moves to program coordinates, at the rapid rate or with the active feed. False: as above. */
bool sinumerik_move_to(struct interp *interp, const slot_values *target, bool rapid);

#endif
