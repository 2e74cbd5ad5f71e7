/* sinumerik_call.h - subprograms: calls, returns, and parts of a program that are repeated. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_CALL_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_CALL_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/* Reads "(1,,NAME)" or nothing into the arguments of the next call or cycle. False: reported. */
bool sinumerik_call_arguments(struct interp *interp, struct lexer *lexer);

/* Calls the subprogram of this upper-case name so many times with the arguments read. False: reported. */
bool sinumerik_call_run(struct interp *interp, const char *name, int repeats, int column);

/* Calls the subprogram of MCALL with its arguments. False: reported. */
bool sinumerik_call_modal(struct interp *interp);

/* RET, M17, or M30 of a subprogram: goes back to the caller, or begins the next round. False: reported. */
bool sinumerik_call_return(struct interp *interp, int column);

/* Is a subprogram being carried out? */
bool sinumerik_call_is_inside(const struct interp *interp);

/* Repeats the part of the program from `entry` to the line `last_line` so many times. False: reported. */
bool sinumerik_call_repeat(struct interp *interp, const struct position *entry, long last_line, int rounds, int column);

/*
 * Has the line in hand left a part that is repeated? Then the next round begins, or the line behind the REPEAT comes
 * next: *left is true. False: reported.
 */
bool sinumerik_call_round(struct interp *interp, bool *left);

/* A jump to this line leaves the parts that do not hold it. */
void sinumerik_call_jumped(struct interp *interp, long line);

bool sinumerik_call_end_of_file(struct interp *interp);

/* The calls under way (struct dialect). */
bool sinumerik_call_caller(const struct interp *interp, size_t level, struct srcloc *at, struct strbuf *title);

#endif
