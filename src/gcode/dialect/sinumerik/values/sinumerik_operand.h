/* sinumerik_operand.h - the operands of expressions: variables, R parameters, functions, constants. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_OPERAND_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_VALUES_SINUMERIK_OPERAND_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"
#include "gcode/eval/expr.h"

/*
 * All functions read at the position of the expression's lexer and move it past the text that they have read; indices
 * are expressions with the same rules. The context of the expression is the interpreter. False: reported.
 */

/* A name or a constant, and everything that belongs to it: the variable of struct expr_rules. */
bool sinumerik_operand_read(struct expr *expr, struct expr_operand *value);

/* For the functions below: sinumerik_expr.h. */
bool sinumerik_operand_whole(struct expr *expr, const char *what, int least, int most, int *value);
bool sinumerik_operand_element(struct expr *expr, const struct sinumerik_variable *variable, size_t *element);
bool sinumerik_operand_r_number(struct expr *expr, const char *name, int *number);
bool sinumerik_operand_axis(struct expr *expr, int *slot);

#endif
