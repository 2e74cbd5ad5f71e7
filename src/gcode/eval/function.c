#include "gcode/eval/function.h"

#include "base/ascii.h"
#include "base/math/math_functions.h"
#include "base/units.h"

#include <math.h>

const struct function_name *function_read(struct lexer *lexer, const struct function_name *names, size_t count)
{
	char byte = lexer_peek(lexer);

	byte = ascii_lower(byte);
	for (size_t i = 0; i < count; i++) {
		if (names[i].lower[0] == byte && lexer_keyword(lexer, names[i].lower))
			return &names[i];
	}
	return NULL;
}

const struct function_name *function_read_short(struct lexer *lexer, const struct function_name *names, size_t count,
						char open)
{
	size_t position = lexer->position;

	for (size_t i = 0; i < count; i++) {
		const char two[3] = {names[i].lower[0], names[i].lower[1], '\0'};

		if (lexer_keyword(lexer, two) && lexer_peek(lexer) == open)
			return &names[i];
		lexer->position = position;
	}
	return NULL;
}

/* A control's numbers cannot represent a right angle exactly: the tangent is large, like theirs, and finite. */
static double tangent(double angle)
{
	const double tangent = math_tan_degrees(angle);

	return isinf(tangent) ? math_tan(radians(angle)) : tangent;
}

static bool compute_inverse(const struct line_place *at, int column, const struct function_name *function,
			    double *value)
{
	double x = *value;

	switch (function->function) {
	case FUNCTION_ACOS:
	case FUNCTION_ASIN:
		if (x < -1 || x > 1)
			return fault(at, column, "%s of %.15g: the value must be from -1 to 1", function->upper, x);
		*value = function->function == FUNCTION_ACOS ? math_acos_degrees(x) : math_asin_degrees(x);
		return true;
	case FUNCTION_LN:
		if (x <= 0)
			return fault(at, column, "%s of %.15g: the value must be greater than 0", function->upper, x);
		*value = math_log(x);
		return true;
	default:
		if (x < 0)
			return fault(at, column, "%s of %.15g: the value must not be negative", function->upper, x);
		*value = sqrt(x);
		return true;
	}
}

bool function_compute(const struct line_place *at, int column, const struct function_name *function, double *value)
{
	/* Computed directly from degrees, because FIX[10*SIN[30]] must be 5. */
	switch (function->function) {
	case FUNCTION_ABS:
		*value = fabs(*value);
		return true;
	case FUNCTION_COS:
		*value = math_cos_degrees(*value);
		return true;
	case FUNCTION_SIN:
		*value = math_sin_degrees(*value);
		return true;
	case FUNCTION_TAN:
		*value = tangent(*value);
		return true;
	case FUNCTION_EXP:
		*value = math_exp(*value);
		return true;
	default:
		return compute_inverse(at, column, function, value);
	}
}

double function_arc_tangent(double y, double x)
{
	return math_atan2_degrees(y, x);
}
