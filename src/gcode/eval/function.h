/* function.h - the functions of expressions that every dialect computes alike. Angles in degrees. */
#ifndef FIVECHECK_GCODE_EVAL_FUNCTION_H
#define FIVECHECK_GCODE_EVAL_FUNCTION_H

#include <stdbool.h>

#include "gcode/text/lexer.h"

enum expr_function {
	EXPR_ABS, EXPR_ACOS, EXPR_ASIN, EXPR_ATAN, EXPR_COS, EXPR_EXISTS, EXPR_EXP, EXPR_FIX, EXPR_FUP, EXPR_LN,
	EXPR_ROUND, EXPR_SIN, EXPR_SQRT, EXPR_TAN, EXPR_FUNCTIONS
};

/* Takes the name of a function, if one comes next. */
bool function_read(struct lexer *lexer, enum expr_function *function);

const char *function_name(enum expr_function function);

/*
 * ABS, ACOS (0 to 180), ASIN (-90 to 90), COS, EXP, LN, SIN, SQRT or TAN; the
 * others have rules of their own in each dialect. False: *value has none, which
 * was reported at the column.
 */
bool function_compute(struct lexer *lexer, int column, enum expr_function function, double *value);

/* From -180 to 180. */
double function_arc_tangent(double y, double x);

#endif
