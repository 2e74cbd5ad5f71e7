/* sinumerik_call.h - subprograms: calls, returns, and parts of a program that are repeated. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_FLOW_SINUMERIK_CALL_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_FLOW_SINUMERIK_CALL_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/* Reads "(1,,NAME)" or nothing into the arguments of the next call or cycle. False: reported. */
bool sinumerik_call_arguments(struct interp *interp, struct lexer *lexer);

/*
 * Calls the subprogram with this upper-case name, of the type 'M' or 'S' if it is not 0, `repeats` times, with the
 * arguments that were read. False: reported.
 */
bool sinumerik_call_run(struct interp *interp, const char *name, char type, int repeats, int column);

/* Calls the subprogram of MCALL with its arguments. False: reported. */
bool sinumerik_call_modal(struct interp *interp);

/* RET, M17, or M30 of a subprogram: returns to the caller, or starts the next repetition. False: reported. */
bool sinumerik_call_return(struct interp *interp, int column);

/* Is a subprogram active? */
bool sinumerik_call_is_inside(const struct interp *interp);

/* Repeats the part of the program from `entry` to the line `last_line` `rounds` times. False: reported. */
bool sinumerik_call_repeat(struct interp *interp, const struct position *entry, long last_line, int rounds, int column);

/*
 * Is the current line after the end of a repeated part? Then the next repetition starts, or the program continues
 * after the REPEAT: *left is true. False: reported.
 */
bool sinumerik_call_round(struct interp *interp, bool *left);

/* Calls this part of the program as a subprogram, once (CALL BLOCK). False: reported. */
bool sinumerik_call_part(struct interp *interp, const struct position *entry, long last_line, int column);

/* A jump to this line ends the repeated parts that do not contain it. False: CALL BLOCK calls such a part; reported. */
bool sinumerik_call_jumped(struct interp *interp, long line, int column);

/* Checks that the last line of a part of CALL BLOCK has only a label, and no words at this column. False: reported. */
bool sinumerik_call_check_last(struct interp *interp, int column);

/* Checks that the end of a program or subprogram is not in a part that CALL BLOCK calls. False: reported. */
bool sinumerik_call_check_end(struct interp *interp, int column);

bool sinumerik_call_end_of_file(struct interp *interp);

/* The active calls (struct dialect). */
bool sinumerik_call_caller(const struct interp *interp, size_t level, struct srcloc *at, struct strbuf *title);

#endif
