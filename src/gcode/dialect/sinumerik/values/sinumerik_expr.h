/* sinumerik_expr.h - expressions of numbers and of text, and the names in them. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_EXPR_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_EXPR_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/* All functions read at the lexer's position and move it past the text that they have read. False: reported. */

/* A number: with operators, functions, R parameters, variables and system variables. */
bool sinumerik_expr_number(struct interp *interp, struct lexer *lexer, double *value);

/* A whole number from least to most; `what` names it in the message. */
bool sinumerik_expr_whole(struct interp *interp, struct lexer *lexer, const char *what, int least, int most,
			  int *value);

/* Is a string or a text variable next? Nothing is consumed. */
bool sinumerik_expr_is_text(struct interp *interp, struct lexer *lexer);

/* Text: strings, variables and functions with << between them; numbers may stand among them. */
bool sinumerik_expr_text(struct interp *interp, struct lexer *lexer, struct sinumerik_text *text);

/* "[1,2]" behind the name of an array; of a variable that is none, 0 is the element. */
bool sinumerik_expr_element(struct interp *interp, struct lexer *lexer, const struct sinumerik_variable *variable,
			    size_t *element);

/* The number of the R parameter with this name, R or R1; of R it comes next, in brackets. */
bool sinumerik_expr_r_number(struct interp *interp, struct lexer *lexer, const char *name, int *number);

/* An axis of the machine in brackets or parentheses: its slot. */
bool sinumerik_expr_axis(struct interp *interp, struct lexer *lexer, int *slot);

#endif
