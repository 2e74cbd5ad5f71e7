#include "gcode/dialect/klartext/values/klartext_formula.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "base/math/math_functions.h"
#include "base/same_double.h"
#include "base/units.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/values/klartext_string.h"
#include "gcode/dialect/klartext/values/klartext_value.h"
#include "gcode/eval/expr.h"

/* The largest depth of nested brackets. */
#define DEPTH_MAX 64
/* A relative difference; numbers that differ by less may be equal on the control. */
#define SAME_NUMBER 1e-9

/* --------------------------------------------------------------- formulas */

/* iTNC 530 user's manual, "Entering formulas directly": brackets, then powers, then * / %, then + -. */
static const struct expr_operator operators[] = {
    {"+", EXPR_PLUS, 1, false},	  {"-", EXPR_MINUS, 1, false},	{"*", EXPR_TIMES, 2, false},
    {"/", EXPR_DIVIDE, 2, false}, {"%", EXPR_MODULO, 2, false}, {"^", EXPR_POWER, 3, false},
};

/* A name that starts with another name comes first. */
static const struct function_name functions[] = {
    {"sqrt", "SQRT", FUNCTION_SQRT, false}, {"sq", "SQ", FUNCTION_SQUARE, false},
    {"sin", "SIN", FUNCTION_SIN, false},    {"sgn", "SGN", FUNCTION_SIGN, false},
    {"cos", "COS", FUNCTION_COS, false},    {"tan", "TAN", FUNCTION_TAN, false},
    {"asin", "ASIN", FUNCTION_ASIN, false}, {"acos", "ACOS", FUNCTION_ACOS, false},
    {"atan", "ATAN", FUNCTION_ATAN, false}, {"abs", "ABS", FUNCTION_ABS, false},
    {"log", "LOG", FUNCTION_LOG10, false},  {"ln", "LN", FUNCTION_LN, false},
    {"exp", "EXP", FUNCTION_EXP, false},    {"neg", "NEG", FUNCTION_NEGATE, false},
    {"int", "INT", FUNCTION_FIX, false},    {"frac", "FRAC", FUNCTION_FRACTION, false},
    {"pi", "PI", FUNCTION_PI, false},
};

static bool is_zero(double value)
{
	return fpclassify(value) == FP_ZERO;
}

static size_t before_blanks(const char *text, size_t end)
{
	while (end > 0 && (text[end - 1] == ' ' || text[end - 1] == '\t'))
		end--;
	return end;
}

/* The position of the bracket that the one at `end` closes; 0: there is none. */
static size_t before_brackets(const char *text, size_t end)
{
	int depth = 0;

	while (end > 0) {
		end--;
		depth += text[end] == ')';
		depth -= text[end] == '(';
		if (depth == 0)
			return end;
	}
	return 0;
}

/* Does a minus stand before the value that ends at the operator: "- 2 ^ 2", "3 * -Q1 ^ 2", "-SIN (30) ^ 2"? */
static bool has_minus(const char *text, size_t operator)
{
	size_t end = before_blanks(text, operator);

	while (end > 0 && (ascii_is_alphanumeric(text[end - 1]) || strchr("., \t)", text[end - 1])))
		end = text[end - 1] == ')' ? before_brackets(text, end) : end - 1;
	if (end == 0 || text[end - 1] != '-')
		return false;
	end = before_blanks(text, end - 1);
	return end > 0 && strchr("=(+-*/%^", text[end - 1]);
}

static bool apply(struct expr *expr, int column, const struct expr_operator *operator, struct expr_operand * left,
		  struct expr_operand *right)
{
	const struct line_place *at = expr->lexer->at;
	double *value = &left->number, by = right->number;

	if ((operator->operation == EXPR_DIVIDE || operator->operation == EXPR_MODULO) && is_zero(by))
		return fault(at, column, "division by zero");
	if (operator->operation == EXPR_POWER && * value<0 && !same_double(floor(by), by))
		return fault(at, column, "a negative number to a power that is not whole");
	if (operator->operation == EXPR_POWER && is_zero(fmod(by, 2)) && has_minus(at->text, (size_t)column - 1))
		return fault(at, column,
			     "a minus before a power: whether it belongs to the base is not in the manuals; write "
			     "brackets");
	if (operator->operation == EXPR_MODULO &&(*value < 0 || by < 0))
		return fault(at, column, "%% of a negative number: which sign the control gives it is not known here");
	switch (operator->operation) {
	case EXPR_PLUS:
		*value += by;
		break;
	case EXPR_MINUS:
		*value -= by;
		break;
	case EXPR_TIMES:
		*value *= by;
		break;
	case EXPR_DIVIDE:
		*value /= by;
		break;
	case EXPR_MODULO:
		*value = fmod(*value, by);
		break;
	default:
		*value = math_pow(*value, by);
		break;
	}
	return isfinite(*value) || fault(at, column, "the result is infinite");
}

/* A function applies to the value that follows, which may be in brackets. */
static bool compute(struct expr *expr, int column, const struct function_name *function, struct expr_operand *value)
{
	double *x = &value->number;

	if (function->function == FUNCTION_PI) {
		*x = PI;
		return true;
	}
	if (!expr_enter(expr) || !expr_value(expr, value))
		return false;
	expr->depth--;
	switch (function->function) {
	case FUNCTION_SQUARE:
		*x *= *x;
		return true;
	case FUNCTION_SIGN:
		if (is_zero(*x))
			return fault(expr->lexer->at, column, "SGN of 0 is 0 on newer controls and 1 on older ones");
		*x = (*x > 0) - (*x < 0);
		return true;
	case FUNCTION_NEGATE:
		*x = -*x;
		return true;
	case FUNCTION_FIX:
		*x = trunc(*x);
		return true;
	case FUNCTION_FRACTION:
		*x -= trunc(*x);
		return true;
	case FUNCTION_ATAN:
		*x = function_arc_tangent(*x, 1);
		return true;
	case FUNCTION_LOG10:
		if (!(*x > 0))
			return fault(expr->lexer->at, column, "LOG of %.15g: only positive numbers have one", *x);
		*x = math_log10(*x);
		return true;
	default:
		return function_compute(expr->lexer->at, column, function, x);
	}
}

static bool variable(struct expr *expr, struct expr_operand *value)
{
	if (!klartext_value_follows(expr->lexer))
		return fault(expr->lexer->at, lexer_next_column(expr->lexer),
			     "a string (QS) in a formula is not supported");
	return klartext_q_read(expr->lexer, &value->number);
}

static const struct expr_rules rules = {
    .open = '(',
    .close = ')',
    .variable_starts = "Qq",
    .operators = operators,
    .operator_count = sizeof(operators) / sizeof(operators[0]),
    .functions = functions,
    .function_count = sizeof(functions) / sizeof(functions[0]),
    .decimal_comma = true,
    .depth_max = DEPTH_MAX,
    .nested = "brackets and functions",
    .apply = apply,
    .function = compute,
    .variable = variable,
};

static bool assign(struct lexer *lexer, struct klartext_q *q, int number, int column, double value)
{
	struct interp *interp = lexer->context;

	if (q == &klartext_of(interp)->values.q[number] && number >= 100 && number < 120)
		return fault(lexer->at, column, "Q%d belongs to the control: a program cannot assign it", number);
	*q = (struct klartext_q){.value = value, .given = true};
	return true;
}

bool klartext_formula_assign(struct lexer *lexer)
{
	int column = lexer_next_column(lexer), number;
	struct expr expr = {.lexer = lexer, .rules = &rules};
	struct expr_operand value;
	struct klartext_q *q;
	bool of_string;
	double result;

	if (klartext_string_follows(lexer))
		return klartext_string_assign(lexer);
	if (!klartext_value_follows(lexer))
		return fault(lexer->at, column, "a Q parameter is needed here");
	q = klartext_q_find(lexer, &number);
	if (!q)
		return false;
	if (lexer_peek(lexer) != '=')
		return fault(lexer->at, lexer_column(lexer), "'=' is needed here");
	lexer_take(lexer);
	if (!klartext_string_compute(lexer, &result, &of_string))
		return false;
	if (of_string)
		return klartext_expect_end(lexer) && assign(lexer, q, number, column, result);
	return expr_sum(&expr, &value) && klartext_expect_end(lexer) && assign(lexer, q, number, column, value.number);
}

/* ---------------------------------------------------------- FN 9 to FN 12 */

/* Is this "Q5 IS" of FN 9: IF Q5 IS UNDEFINED? The lexer stays. */
static bool asks_definition(const struct lexer *before)
{
	struct lexer lexer = *before;

	if (lexer_peek(&lexer) == '+')
		lexer_take(&lexer);
	if (ascii_upper(lexer_peek(&lexer)) != 'Q')
		return false;
	lexer_take(&lexer);
	while (ascii_upper(lexer_peek(&lexer)) == 'L' || ascii_upper(lexer_peek(&lexer)) == 'R')
		lexer_take(&lexer);
	while (ascii_is_digit(lexer_peek(&lexer)))
		lexer_take(&lexer);
	return klartext_take(&lexer, "IS");
}

/*
 * A parameter that the program has not set is known to be undefined only after SET UNDEFINED; otherwise it may hold a
 * value from before the program.
 */
static bool read_definition(struct lexer *lexer, bool *holds)
{
	const struct klartext_q *q;
	struct lexer value;
	bool undefined;
	double unused;
	int number;

	if (lexer_peek(lexer) == '+')
		lexer_take(lexer);
	value = *lexer;
	q = klartext_q_find(lexer, &number);
	if (!q || (!q->given && !q->undefined && !klartext_q_read(&value, &unused)))
		return false;
	klartext_take(lexer, "IS");
	undefined = klartext_take(lexer, "UNDEFINED");
	if (!undefined && !klartext_take(lexer, "DEFINED"))
		return fault(lexer->at, lexer_next_column(lexer), "IS needs DEFINED or UNDEFINED");
	*holds = undefined == q->undefined;
	return true;
}

bool klartext_formula_condition(struct lexer *lexer, int number, bool *holds)
{
	static const char *const names[] = {"EQU", "NE", "GT", "LT"};
	int column = lexer_next_column(lexer);
	double a, b;

	if (!klartext_take(lexer, "IF"))
		return fault(lexer->at, column, "FN %d needs IF here", number);
	column = lexer_next_column(lexer);
	if (number == 9 && asks_definition(lexer))
		return read_definition(lexer, holds);
	if (!klartext_value(lexer, &a))
		return false;
	if (!klartext_take(lexer, names[number - 9]))
		return fault(lexer->at, lexer_next_column(lexer), "FN %d compares by %s", number, names[number - 9]);
	if (!klartext_value(lexer, &b))
		return false;
	/* The control rounds differently and may find numbers this close equal. */
	if (!same_double(a, b) && fabs(a - b) < SAME_NUMBER * fmax(1, fmax(fabs(a), fabs(b))))
		return fault(lexer->at, column, "%.15g and %.15g differ by %.2g only: the control may find them equal",
			     a, b, a - b);
	*holds = number == 9 ? same_double(a, b) : number == 10 ? !same_double(a, b) : number == 11 ? a > b : a < b;
	return true;
}

/* ---------------------------------------------------------- FN 0 to FN 13 */

/* Takes the operator between the two values of a function; "DIV" is written out, LEN and ANG are words. */
static bool take_operator(struct lexer *lexer, int number)
{
	static const char *const names[] = {[1] = "+", [2] = "-", [3] = "*", [4] = "DIV", [8] = "LEN", [13] = "ANG"};

	if (klartext_take(lexer, names[number]))
		return true;
	return fault(lexer->at, lexer_next_column(lexer), "FN %d needs %s between its values", number, names[number]);
}

/* Refuses values for which a function has no result. False: reported. */
static bool check_operands(struct lexer *lexer, int number, int column, double a, double b)
{
	if (number == 4 && is_zero(b))
		return fault(lexer->at, column, "division by zero");
	if (number == 5 && a < 0)
		return fault(lexer->at, column, "SQRT of %.15g: negative numbers have none", a);
	return true;
}

static double result(int number, double a, double b)
{
	switch (number) {
	case 1:
		return a + b;
	case 2:
		return a - b;
	case 3:
		return a * b;
	case 4:
		return a / b;
	case 5:
		return sqrt(a);
	case 6:
		return math_sin_degrees(a);
	case 7:
		return math_cos_degrees(a);
	case 8:
		return math_hypot(a, b);
	case 13: {
		double angle = function_arc_tangent(a, b);

		return angle < 0 ? angle + 360 : angle;
	}
	default:
		return a;
	}
}

bool klartext_formula_function(struct lexer *lexer, int number)
{
	static const char *const unary[] = {[5] = "SQRT", [6] = "SIN", [7] = "COS"};
	int column = lexer_next_column(lexer), index;
	double a, b = 0;
	struct klartext_q *q;

	if (lexer_peek(lexer) != 'Q' && lexer_peek(lexer) != 'q')
		return fault(lexer->at, column, "a Q parameter is needed here");
	q = klartext_q_find(lexer, &index);
	if (!q)
		return false;
	if (number == 0 && klartext_take(lexer, "SET")) {
		if (!klartext_take(lexer, "UNDEFINED"))
			return fault(lexer->at, lexer_next_column(lexer), "SET needs UNDEFINED");
		*q = (struct klartext_q){.undefined = true};
		return klartext_expect_end(lexer);
	}
	if (lexer_peek(lexer) != '=')
		return fault(lexer->at, lexer_column(lexer), "'=' is needed here");
	lexer_take(lexer);
	if (number >= 5 && number <= 7 && !klartext_take(lexer, unary[number]))
		return fault(lexer->at, lexer_next_column(lexer), "FN %d needs %s here", number, unary[number]);
	if (!klartext_value(lexer, &a))
		return false;
	if ((number >= 1 && number <= 4) || number == 8 || number == 13) {
		if (!take_operator(lexer, number) || !klartext_value(lexer, &b))
			return false;
	}
	return klartext_expect_end(lexer) && check_operands(lexer, number, column, a, b) &&
	       assign(lexer, q, index, column, result(number, a, b));
}
