/* sinumerik_proc.h - what a subprogram begins with: PROC, its parameters, and SAVE. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_PROC_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_PROC_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/* PROC: takes over the arguments of the call. False: reported. */
bool sinumerik_proc_take(struct interp *interp, struct lexer *lexer);

/* The first block of a subprogram without PROC: it has no parameters. False: reported. */
bool sinumerik_proc_none(struct interp *interp);

/*
 * 840D sl, "Number of program repetitions (P)": parameters are transferred at the call alone. Whether what the
 * subprogram itself makes of them holds in the next round is not said.
 */
bool sinumerik_proc_check_begun(struct interp *interp, const struct sinumerik_call *call, int column);

#endif
