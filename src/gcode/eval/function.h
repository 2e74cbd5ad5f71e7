/* function.h - the functions of expressions that every dialect computes alike. Angles are in degrees. */
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
	const char *lower, *upper;	/* as lexer_keyword takes it, and as messages call it */
	enum function function;
	bool refused;	/* another control has it, and this one does not */
};

/* Takes the name of a function if one comes next; NULL: nothing was taken. */
const struct function_name *function_read(struct lexer *lexer, const struct function_name *names, size_t count);

/* The same by the first two letters of the name, with the bracket `open` behind them, which is not taken. */
const struct function_name *function_read_short(struct lexer *lexer, const struct function_name *names, size_t count,
						char open);

/*
 * ABS, ACOS (0 to 180), ASIN (-90 to 90), COS, EXP, LN, SIN, SQRT or TAN. The
 * others have rules of their own in each dialect. False: *value has no result,
 * which was reported at the column.
 */
bool function_compute(const struct line_place *at, int column, const struct function_name *function, double *value);

/* From -180 to 180. */
double function_arc_tangent(double y, double x);

#endif
