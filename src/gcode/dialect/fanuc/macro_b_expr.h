/* macro_b_expr.h - values as Fanuc's and Haas's macros write them: variables, vacant ones, expressions, conditions. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_EXPR_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_EXPR_H

#include <stdbool.h>

#include "gcode/text/lexer.h"

/* Brackets inside each other; Fanuc has five (B-63944EN, bracket nesting). */
#define MACRO_EXPR_DEPTH_MAX 32

/*
 * Fanuc Series 30i/31i/32i operator's manual (B-63944EN), custom macro,
 * variables and arithmetic and logic operation; Haas mill operator's
 * manual, "Macros". Where Haas's is silent (the order of AND, OR and XOR
 * among others, sums of undefined values), it is a fault and no guess. All read
 * at the lexer's position and leave it behind what they read. False: reported.
 */

/* Does #, [, a sign or a function come next? Nothing is taken. */
bool macro_b_expr_follows(struct lexer *lexer);

/*
 * The value behind the address word->letter: #1, -#1, [#1+2]. A vacant
 * variable makes the word vacant. By lexer->macro, the value is rounded to the
 * increment of the address.
 */
bool macro_b_expr_word(struct lexer *lexer, struct word *word);

/* What stands behind '=': an expression without brackets of its own. NAN: vacant. */
bool macro_b_expr_sum(struct lexer *lexer, double *value);

/* A condition in brackets. */
bool macro_b_expr_condition(struct lexer *lexer, const char *what, bool *holds);

/* A whole number that is not vacant: 10, #1, [#1+1]; `what` says what it is. */
bool macro_b_expr_integer(struct lexer *lexer, const char *what, int *value);

/* "#10" or "#[#1+1]": the variable's number. */
bool macro_b_expr_variable(struct lexer *lexer, int *number);

#endif
