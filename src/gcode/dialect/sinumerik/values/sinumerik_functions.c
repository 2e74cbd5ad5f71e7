#include "gcode/dialect/sinumerik/values/sinumerik_functions.h"

#include <math.h>
#include <string.h>

enum own { OWN_NONE, OWN_SQUARE, OWN_TRUNC, OWN_ROUND, OWN_ROUND_UP, OWN_LEAST, OWN_MOST, OWN_ATAN2, OWN_BOUND };

/* 840D sl, job planning, "Arithmetic functions". Functions of function.h have OWN_NONE. */
static const struct known {
	struct function_name name;
	enum own own;
	int arguments;
} functions[] = {
	{{"sin", "SIN", FUNCTION_SIN, false}, OWN_NONE, 1},
	{{"cos", "COS", FUNCTION_COS, false}, OWN_NONE, 1},
	{{"tan", "TAN", FUNCTION_TAN, false}, OWN_NONE, 1},
	{{"asin", "ASIN", FUNCTION_ASIN, false}, OWN_NONE, 1},
	{{"acos", "ACOS", FUNCTION_ACOS, false}, OWN_NONE, 1},
	{{"sqrt", "SQRT", FUNCTION_SQRT, false}, OWN_NONE, 1},
	{{"abs", "ABS", FUNCTION_ABS, false}, OWN_NONE, 1},
	{{"ln", "LN", FUNCTION_LN, false}, OWN_NONE, 1},
	{{"exp", "EXP", FUNCTION_EXP, false}, OWN_NONE, 1},
	{{"pot", "POT", FUNCTION_ABS, false}, OWN_SQUARE, 1},
	{{"trunc", "TRUNC", FUNCTION_FIX, false}, OWN_TRUNC, 1},
	{{"round", "ROUND", FUNCTION_ROUND, false}, OWN_ROUND, 1},
	{{"roundup", "ROUNDUP", FUNCTION_FUP, false}, OWN_ROUND_UP, 1},
	{{"atan2", "ATAN2", FUNCTION_ATAN, false}, OWN_ATAN2, 2},
	{{"minval", "MINVAL", FUNCTION_ABS, false}, OWN_LEAST, 2},
	{{"maxval", "MAXVAL", FUNCTION_ABS, false}, OWN_MOST, 2},
	{{"bound", "BOUND", FUNCTION_ABS, false}, OWN_BOUND, 3},
};

static const struct known *find(const char *name)
{
	for (size_t i = 0; i < sizeof(functions) / sizeof(functions[0]); i++) {
		if (!strcmp(functions[i].name.upper, name))
			return &functions[i];
	}
	return NULL;
}

bool sinumerik_functions_is(const char *name)
{
	return find(name) != NULL;
}

static double compute_own(enum own own, const double *x)
{
	switch (own) {
	case OWN_SQUARE:
		return x[0] * x[0];
	case OWN_TRUNC:
		return trunc(x[0]);
	case OWN_ROUND:
		return round(x[0]);
	case OWN_ROUND_UP:
		return ceil(x[0]);
	case OWN_LEAST:
		return fmin(x[0], x[1]);
	case OWN_MOST:
		return fmax(x[0], x[1]);
	case OWN_ATAN2:
		return function_arc_tangent(x[0], x[1]);
	default:
		return fmin(fmax(x[2], x[0]), x[1]);
	}
}

static bool read_arguments(struct expr *expr, const struct known *known, double *arguments)
{
	for (int i = 0; i < known->arguments; i++) {
		struct expr_operand operand;

		if (i > 0 && lexer_peek(expr->lexer) != ',')
			return fault(expr->lexer->at, lexer_next_column(expr->lexer),
				     "%s has %d arguments, with ',' between them", known->name.upper, known->arguments);
		if (i > 0)
			lexer_take(expr->lexer);
		if (!expr_sum(expr, &operand))
			return false;
		arguments[i] = operand.number;
	}
	return true;
}

/* NOT and B_NOT stand before their value, and bind more strongly than any operator. */
static bool negate(struct expr *expr, bool bits, int column, double *value)
{
	struct expr_operand operand;

	if (!expr_enter(expr) || !expr_value(expr, &operand))
		return false;
	expr->depth--;
	if (bits && (fabs(operand.number) > 2147483647.0 || floor(operand.number) < operand.number))
		return fault(expr->lexer->at, column, "B_NOT needs a whole number, not %.15g", operand.number);
	*value = bits ? (double)~(long)operand.number : fpclassify(operand.number) == FP_ZERO;
	return true;
}

bool sinumerik_functions_compute(struct expr *expr, const char *name, int column, double *value)
{
	const struct known *known = find(name);
	double arguments[3] = {0};

	if (!strcmp(name, "NOT") || !strcmp(name, "B_NOT"))
		return negate(expr, name[0] == 'B', column, value);
	if (!known)
		return fault(expr->lexer->at, column, "the function %s is not known here", name);
	if (!expr_open(expr, known->name.upper) || !read_arguments(expr, known, arguments) || !expr_close(expr))
		return false;
	*value = known->own ? compute_own(known->own, arguments) : arguments[0];
	return known->own || function_compute(expr->lexer->at, column, &known->name, value);
}
