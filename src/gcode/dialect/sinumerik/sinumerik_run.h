/* sinumerik_run.h - carries out one block, its words in the control's order. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_RUN_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_RUN_H

#include "gcode/dialect/sinumerik/sinumerik_block.h"

/*
 * Carries out the block that has been read; the arguments of its call come next in the lexer. Sets interp->ended at
 * the end of the program. False: reported, or the sink wants no more.
 */
bool sinumerik_run(struct interp *interp, struct lexer *lexer, const struct sinumerik_block *block);

#endif
