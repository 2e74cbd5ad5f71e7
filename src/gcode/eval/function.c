#include "gcode/eval/function.h"

#include <math.h>

/* Long doubles, as LinuxCNC computes: FIX[10*SIN[30]] must be 5 there and here. */
#define PI_LONG 3.141592653589793238462643383279502884L

static const struct {
	const char *lower, *upper;
} names[EXPR_FUNCTIONS] = {{"abs", "ABS"},	 {"acos", "ACOS"}, {"asin", "ASIN"}, {"atan", "ATAN"}, {"cos", "COS"},
			   {"exists", "EXISTS"}, {"exp", "EXP"},   {"fix", "FIX"},   {"fup", "FUP"},   {"ln", "LN"},
			   {"round", "ROUND"},	 {"sin", "SIN"},   {"sqrt", "SQRT"}, {"tan", "TAN"}};

bool function_read(struct lexer *lexer, enum expr_function *function)
{
	for (int i = 0; i < EXPR_FUNCTIONS; i++) {
		if (lexer_keyword(lexer, names[i].lower)) {
			*function = (enum expr_function)i;
			return true;
		}
	}
	return false;
}

const char *function_name(enum expr_function function)
{
	return names[function].upper;
}

static double from_radians(double radians)
{
	return (double)((long double)(radians * 180) / PI_LONG);
}

static bool compute_inverse(struct lexer *lexer, int column, enum expr_function function, double *value)
{
	double x = *value;

	switch (function) {
	case EXPR_ACOS:
	case EXPR_ASIN:
		if (x < -1 || x > 1)
			return fault(lexer->at, column, "%s of %.15g: only numbers from -1 to 1 have one",
				     names[function].upper, x);
		*value = from_radians(function == EXPR_ACOS ? acos(x) : asin(x));
		return true;
	case EXPR_LN:
		if (x <= 0)
			return fault(lexer->at, column, "LN of %.15g: only positive numbers have one", x);
		*value = log(x);
		return true;
	default:
		if (x < 0)
			return fault(lexer->at, column, "SQRT of %.15g: negative numbers have none", x);
		*value = sqrt(x);
		return true;
	}
}

bool function_compute(struct lexer *lexer, int column, enum expr_function function, double *value)
{
	long double angle = (long double)*value * PI_LONG / 180;

	switch (function) {
	case EXPR_ABS:
		*value = fabs(*value);
		return true;
	case EXPR_COS:
		*value = (double)cosl(angle);
		return true;
	case EXPR_SIN:
		*value = (double)sinl(angle);
		return true;
	case EXPR_TAN:
		*value = (double)tanl(angle);
		return true;
	case EXPR_EXP:
		*value = exp(*value);
		return true;
	default:
		return compute_inverse(lexer, column, function, value);
	}
}

double function_arc_tangent(double y, double x)
{
	return from_radians(atan2(y, x));
}
