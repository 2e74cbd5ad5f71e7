/* macro_b_expr.h - values in macros: variables, also vacant ones, expressions, conditions. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_EXPR_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_EXPR_H

#include <stdbool.h>

#include "gcode/eval/expr.h"
#include "gcode/text/lexer.h"

/* The greatest depth of nested brackets; Fanuc has five (B-63944EN, bracket nesting). */
#define MACRO_B_DEPTH_MAX 32

/*
 * Fanuc Series 30i/31i/32i operator's manual (B-63944EN), custom macro, variables and arithmetic and logic operation;
 * Haas mill operator's manual, "Macros". What Haas's manual does not define (the precedence of AND, OR and XOR among
 * other operators, sums of undefined values) is a fault, not a guess. All functions read at the lexer's position and
 * move it past the text that they have read. False: the fault was reported. The context of the lexer is the struct
 * interp.
 */

struct interp;

/*
 * The rules for a block's words: values are rounded to the increment of the address, and a vacant variable makes its
 * word vacant; and the rules for a call's arguments, which are not rounded.
 */
const struct lexer_rules *macro_b_word_rules(const struct interp *interp);
const struct lexer_rules *macro_b_argument_rules(const struct interp *interp);

/* The hooks for expressions of all controls with macros. */
bool macro_b_expr_apply(struct expr *expr, int column, const struct expr_operator *operator, struct expr_operand *left,
			struct expr_operand *right);
bool macro_b_expr_function(struct expr *expr, int column, const struct function_name *function,
			   struct expr_operand *value);
bool macro_b_expr_variable(struct expr *expr, struct expr_operand *value);

/* Reads the expression after '=', which has no outer brackets. NAN: vacant. */
bool macro_b_expr_sum(struct lexer *lexer, double *value);

/* Reads a condition in brackets. */
bool macro_b_expr_condition(struct lexer *lexer, const char *what, bool *holds);

/* Reads a whole number that is not vacant: 10, #1, [#1+1]; `what` names it in messages. */
bool macro_b_expr_integer(struct lexer *lexer, const char *what, int *value);

/* "#10" or "#[#1+1]": the variable's number. */
bool macro_b_expr_variable_number(struct lexer *lexer, int *number);

#endif
