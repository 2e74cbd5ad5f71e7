/* sinumerik_proc.h - the head of a subprogram: PROC, its parameters, and SAVE. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_FLOW_SINUMERIK_PROC_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_FLOW_SINUMERIK_PROC_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/* Executes PROC: its parameters receive the arguments of the call. False: reported. */
bool sinumerik_proc_take(struct interp *interp, struct lexer *lexer);

/* Call at the first block of a subprogram without PROC: it has no parameters. False: arguments were given; reported. */
bool sinumerik_proc_none(struct interp *interp);

/*
 * 840D sl, "Number of program repetitions (P)": parameters are passed only at the call. It is not documented whether
 * a value that the subprogram assigns to a parameter remains in the next repetition.
 */
bool sinumerik_proc_check_begun(struct interp *interp, const struct sinumerik_call *call, int column);

#endif
