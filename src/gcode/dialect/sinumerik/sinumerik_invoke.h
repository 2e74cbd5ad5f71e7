/* sinumerik_invoke.h - calls of cycles and subprograms in a block, and the modal calls of MCALL. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_INVOKE_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_INVOKE_H

#include "gcode/dialect/sinumerik/block/sinumerik_block.h"

/*
 * Executes the call of the block, if it has one, or its MCALL; the arguments come next in the lexer. False: reported.
 */
bool sinumerik_invoke_call(struct interp *interp, struct lexer *lexer, const struct sinumerik_block *block);

/* After a move to a position: executes the cycle or the subprogram of MCALL. False: reported. */
bool sinumerik_invoke_modal(struct interp *interp);

/*
 * A block without motion: refuses it if the control would execute the modal call for its F, S, G0 or G1. False:
 * reported.
 */
bool sinumerik_invoke_check(struct interp *interp, const struct sinumerik_block *block);

#endif
