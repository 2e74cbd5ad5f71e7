/* macro_b_operators.h - the operators of macros, also for vacant values. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_OPERATORS_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_OPERATORS_H

#include <stdbool.h>

#include "gcode/dialect/fanuc/macro_b_rules.h"
#include "gcode/text/fault.h"

/* *left becomes the result. False: reported at the column. */
bool macro_b_operators_apply(const struct macro_b_rules *rules, const struct line_place *at, int column,
			     enum expr_operation operation, struct expr_operand *left, struct expr_operand *right);

/* Sets a vacant value to 0 on controls where vacant values count as 0; else it is a fault, reported at the column. */
bool macro_b_operators_fill(const struct macro_b_rules *rules, const struct line_place *at, int column,
			    struct expr_operand *value);

/* Do the values differ, but by so little that controls may disagree? */
bool macro_b_operators_nearly_equal(double left, double right);

/* Is the value a whole number with an absolute value below 2^31? */
bool macro_b_operators_is_whole(double value);

#endif
