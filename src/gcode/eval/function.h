/* function.h - the functions of expressions that are the same in every dialect. Angles are in degrees. */
#ifndef FIVECHECK_GCODE_EVAL_FUNCTION_H
#define FIVECHECK_GCODE_EVAL_FUNCTION_H

#include <stdbool.h>
#include <stddef.h>

#include "gcode/text/lexer.h"

enum function {
	FUNCTION_ABS, FUNCTION_ACOS, FUNCTION_ASIN, FUNCTION_ATAN, FUNCTION_COS, FUNCTION_EXISTS, FUNCTION_EXP,
	FUNCTION_FIX, FUNCTION_FUP, FUNCTION_LN, FUNCTION_ROUND, FUNCTION_SIN, FUNCTION_SQRT, FUNCTION_TAN,
	FUNCTION_FRACTION, FUNCTION_LOG10, FUNCTION_NEGATE, FUNCTION_PI, FUNCTION_POWER, FUNCTION_SIGN, FUNCTION_SQUARE
};

/* A row of a dialect's table. */
struct function_name {
	const char *lower, *upper;	/* for lexer_keyword, and for messages */
	enum function function;
	bool refused;	/* a function of another control, which this control does not have */
};

/* Reads the name of a function if one comes next; NULL: nothing was consumed. */
const struct function_name *function_read(struct lexer *lexer, const struct function_name *names, size_t count);

/* The same for the first two letters of the name, followed by the bracket `open`, which is not consumed. */
const struct function_name *function_read_short(struct lexer *lexer, const struct function_name *names, size_t count,
						char open);

/*
 * Computes ABS, ACOS (0 to 180), ASIN (-90 to 90), COS, EXP, LN, SIN, SQRT or TAN; the other functions have different
 * rules in each dialect. False: the function has no result for *value, which was reported at the column.
 */
bool function_compute(const struct line_place *at, int column, const struct function_name *function, double *value);

/* From -180 to 180. */
double function_arc_tangent(double y, double x);

#endif
