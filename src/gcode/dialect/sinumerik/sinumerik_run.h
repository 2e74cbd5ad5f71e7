/* sinumerik_run.h - executes one block, its words in the order of the control. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_RUN_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_RUN_H

#include "gcode/dialect/sinumerik/block/sinumerik_block.h"

/*
 * Executes the block that has been read; the arguments of its call come next in the lexer. Sets interp->ended at the
 * end of the program. False: reported, or the sink wants no more.
 */
bool sinumerik_run(struct interp *interp, struct lexer *lexer, const struct sinumerik_block *block);

#endif
