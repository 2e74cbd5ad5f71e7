/* sinumerik_own_block.h - codes that take the words of their block, which no second code can then take. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_OWN_BLOCK_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_OWN_BLOCK_H

#include "gcode/dialect/sinumerik/block/sinumerik_block.h"

/*
 * 840D sl, "List of G functions", groups 2 and 3: dwells, fixed points, limits of the working area, frames and poles
 * stand in a block of their own. The codes of other groups may be set beside them, but no word may be left that is
 * theirs. False: reported at the code or word that has no place there.
 */
bool sinumerik_own_block_check(struct interp *interp, const struct sinumerik_block *block);

/* Carries out such a code. *done: there is one, and it has taken the words of the block. False: reported. */
bool sinumerik_own_block_run(struct interp *interp, const struct sinumerik_block *block, bool *done);

#endif
