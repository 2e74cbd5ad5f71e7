/* macro_b_expr.h - values as macros write them: variables, vacant ones, expressions, conditions. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_EXPR_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_EXPR_H

#include <stdbool.h>

#include "gcode/eval/expr.h"
#include "gcode/text/lexer.h"

/* Brackets inside each other; Fanuc has five (B-63944EN, bracket nesting). */
#define MACRO_B_DEPTH_MAX 32

/*
 * Fanuc Series 30i/31i/32i operator's manual (B-63944EN), custom macro,
 * variables and arithmetic and logic operation; Haas mill operator's
 * manual, "Macros". Where Haas's is silent (the order of AND, OR and XOR
 * among others, sums of undefined values), it is a fault and no guess. All read
 * at the lexer's position and leave it behind what they read. False: the fault
 * was reported. The context of the lexer is the struct interp.
 */

struct interp;

/*
 * Of a block's words: their values are rounded to the increment of the address,
 * and a vacant variable makes its word vacant. And of a call's arguments, which are not rounded.
 */
const struct lexer_rules *macro_b_word_rules(const struct interp *interp);
const struct lexer_rules *macro_b_argument_rules(const struct interp *interp);

/* The hooks of the expressions of all controls that have macros. */
bool macro_b_expr_apply(struct expr *expr, int column, const struct expr_operator *operator, struct expr_operand *left,
			struct expr_operand *right);
bool macro_b_expr_function(struct expr *expr, int column, const struct function_name *function,
			   struct expr_operand *value);
bool macro_b_expr_variable(struct expr *expr, struct expr_operand *value);

/* What stands behind '=': an expression without brackets of its own. NAN: vacant. */
bool macro_b_expr_sum(struct lexer *lexer, double *value);

/* A condition in brackets. */
bool macro_b_expr_condition(struct lexer *lexer, const char *what, bool *holds);

/* A whole number that is not vacant: 10, #1, [#1+1]; `what` says what it is. */
bool macro_b_expr_integer(struct lexer *lexer, const char *what, int *value);

/* "#10" or "#[#1+1]": the variable's number. */
bool macro_b_expr_variable_number(struct lexer *lexer, int *number);

#endif
