#include "gcode/dialect/linuxcnc/linuxcnc_expr.h"

#include <math.h>

#include "base/ascii.h"
#include "base/math/math_functions.h"
#include "base/same_double.h"
#include "gcode/dialect/linuxcnc/linuxcnc_state.h"
#include "gcode/dialect/linuxcnc/system_param_names.h"
#include "gcode/dialect/linuxcnc/system_params.h"
#include "gcode/eval/expr.h"

/* LinuxCNC's TOLERANCE_EQUAL: EQ and NE treat such numbers as equal; up to version 2.9 it was coarser. */
#define EQUAL_TOLERANCE 1e-6
#define EQUAL_TOLERANCE_2_9 1e-4
/* Its tolerance for whole numbers. */
#define INTEGER_TOLERANCE 0.0001
/*
 * If the exact sine, cosine or tangent of an angle other than 0 is 0, LinuxCNC (interp_execute.cc) computes it from a
 * rounded multiple of pi, in the long double of its processor: the result is below 1e-18, with either sign. Here it is
 * a number far smaller than any other number of a program, and anything that depends on its sign is refused.
 */
#define UNSURE_ZERO 1e-30
#define UNSURE_MAX 1e-18
/* The greatest depth of nested brackets and '#'. */
#define DEPTH_MAX 256

static bool is_zero(double value)
{
	return fpclassify(value) == FP_ZERO;
}

static bool expect(struct lexer *lexer, char byte, const char *where)
{
	if (lexer_peek(lexer) != byte)
		return fault(lexer->at, lexer_column(lexer), "'%c' is missing %s", byte, where);
	lexer_take(lexer);
	return true;
}

bool linuxcnc_expr_sign_is_sure(const struct line_place *at, int column, double value)
{
	return is_zero(value) || fabs(value) > UNSURE_MAX ||
	       fault(at, column,
		     "the rounding error of a sine, cosine or tangent decides whether this number is 0; round it, or "
		     "compare with a margin");
}

/* -------------------------------------------------------------- operators */

static const struct expr_operator operators[] = {
	{"+", EXPR_PLUS, 3, false},   {"-", EXPR_MINUS, 3, false}, {"/", EXPR_DIVIDE, 4, false},
	{"**", EXPR_POWER, 5, false}, {"*", EXPR_TIMES, 4, false}, {"and", EXPR_AND, 1, false},
	{"or", EXPR_OR, 1, false},    {"xor", EXPR_XOR, 1, false}, {"mod", EXPR_MODULO, 4, false},
	{"eq", EXPR_EQ, 2, false},    {"ne", EXPR_NE, 2, false},   {"lt", EXPR_LT, 2, false},
	{"le", EXPR_LE, 2, false},    {"gt", EXPR_GT, 2, false},   {"ge", EXPR_GE, 2, false},
};

static bool power(const struct line_place *at, int column, double *left, double right)
{
	if (!linuxcnc_expr_sign_is_sure(at, column, *left))
		return false;
	if (*left < 0 && !same_double(floor(right), right))
		return fault(at, column, "a negative number has only whole powers");
	*left = math_pow(*left, right);
	return true;
}

static bool divide(const struct line_place *at, int column, enum expr_operation operation, double *left, double right)
{
	if (is_zero(right))
		return fault(at, column, "division by zero");
	if (!linuxcnc_expr_sign_is_sure(at, column, right))
		return false;
	if (operation == EXPR_DIVIDE) {
		*left /= right;
		return true;
	}
	if (!linuxcnc_expr_sign_is_sure(at, column, *left))
		return false;
	*left = fmod(*left, right);
	/* The result of MOD is never negative. */
	if (*left < 0)
		*left += fabs(right);
	return true;
}

/* LinuxCNC 2.9 compares exactly; later versions treat nearly equal numbers as equal in LE and GE, too. */
static bool compare(const struct line_place *at, int column, enum expr_operation operation, double *left, double right)
{
	static const char *const names[] = {
	    [EXPR_EQ] = "EQ", [EXPR_NE] = "NE", [EXPR_LE] = "LE", [EXPR_GE] = "GE"};
	double difference = fabs(*left - right);
	bool ordered = operation == EXPR_LE || operation == EXPR_GE, equal = difference < EQUAL_TOLERANCE;
	bool holds = operation == EXPR_EQ   ? equal
		     : operation == EXPR_NE ? !equal
		     : operation == EXPR_LE ? *left <= right
					    : *left >= right;

	if (ordered ? !holds && equal : !equal && difference < EQUAL_TOLERANCE_2_9)
		return fault(at, column,
			     "%s of numbers that differ by only %.2g: versions of LinuxCNC disagree; compare with a "
			     "margin",
			     names[operation], difference);
	*left = holds;
	return true;
}

/* Has a comparison or logical operation the same result for each sign of an unsure zero? EQ and NE have. */
static bool is_decided(const struct line_place *at, int column, enum expr_operation operation, double left,
		       double right)
{
	switch (operation) {
	case EXPR_LT:
	case EXPR_GT:
	case EXPR_LE:
	case EXPR_GE:
		return linuxcnc_expr_sign_is_sure(at, column, left - right);
	case EXPR_AND:
	case EXPR_OR:
	case EXPR_XOR:
		return linuxcnc_expr_sign_is_sure(at, column, left) && linuxcnc_expr_sign_is_sure(at, column, right);
	default:
		return true;
	}
}

static bool apply(struct expr *expr, int column, const struct expr_operator *operator,
		  struct expr_operand *left_operand, struct expr_operand *right_operand)
{
	const struct line_place *at = expr->lexer->at;
	double *left = &left_operand->number, right = right_operand->number;

	if (!is_decided(at, column, operator->operation, *left, right))
		return false;
	switch (operator->operation) {
	case EXPR_POWER:
		return power(at, column, left, right);
	case EXPR_DIVIDE:
	case EXPR_MODULO:
		return divide(at, column, operator->operation, left, right);
	case EXPR_TIMES:
		*left *= right;
		return true;
	case EXPR_PLUS:
		*left += right;
		return true;
	case EXPR_MINUS:
		*left -= right;
		return true;
	case EXPR_LT:
		*left = *left < right;
		return true;
	case EXPR_GT:
		*left = *left > right;
		return true;
	case EXPR_EQ:
	case EXPR_NE:
	case EXPR_LE:
	case EXPR_GE:
		return compare(at, column, operator->operation, left, right);
	case EXPR_AND:
		*left = !is_zero(*left) && !is_zero(right);
		return true;
	case EXPR_OR:
		*left = !is_zero(*left) || !is_zero(right);
		return true;
	case EXPR_XOR:
		*left = is_zero(*left) != is_zero(right);
		return true;
	default:
		return false;
	}
}

/* -------------------------------------------------------------- functions */

static const struct function_name functions[] = {
	{"abs", "ABS", FUNCTION_ABS, false},	{"acos", "ACOS", FUNCTION_ACOS, false},
	{"asin", "ASIN", FUNCTION_ASIN, false}, {"atan", "ATAN", FUNCTION_ATAN, false},
	{"cos", "COS", FUNCTION_COS, false},	{"exists", "EXISTS", FUNCTION_EXISTS, false},
	{"exp", "EXP", FUNCTION_EXP, false},	{"fix", "FIX", FUNCTION_FIX, false},
	{"fup", "FUP", FUNCTION_FUP, false},	{"ln", "LN", FUNCTION_LN, false},
	{"round", "ROUND", FUNCTION_ROUND, false}, {"sin", "SIN", FUNCTION_SIN, false},
	{"sqrt", "SQRT", FUNCTION_SQRT, false}, {"tan", "TAN", FUNCTION_TAN, false},
};

/* LinuxCNC rounds through an int, halves away from zero. */
static bool compute_round(const struct line_place *at, int column, double *value)
{
	double moved = *value + (*value < 0 ? -0.5 : 0.5);

	if (fabs(moved) >= 2147483648.0)
		return fault(at, column, "ROUND of %.15g: LinuxCNC rounds only numbers below 2^31", *value);
	*value = trunc(moved);
	return true;
}

static bool to_integer(struct lexer *lexer, int column, double number, int *value)
{
	double low = floor(number);

	if (number - low > 1 - INTEGER_TOLERANCE)
		low++;
	else if (number - low > INTEGER_TOLERANCE)
		return fault(lexer->at, column, "a whole number is needed, not %.15g", number);
	if (fabs(low) > 2147483647.0)
		return fault(lexer->at, column, "%.15g is too large here", number);
	*value = (int)low;
	return true;
}

static bool read_integer(struct expr *expr, int *value)
{
	int column = lexer_next_column(expr->lexer);
	struct expr_operand operand;

	return expr_value(expr, &operand) && to_integer(expr->lexer, column, operand.number, value);
}

/* EXISTS[#<name>]; a numbered parameter exists if the number is valid. */
static bool read_exists(struct expr *expr, double *value)
{
	struct lexer *lexer = expr->lexer;
	struct interp *interp = expr->context;
	char name[PARAM_NAME_MAX + 1];
	int number;

	if (!expect(lexer, '[', "after EXISTS") || !expect(lexer, '#', "in EXISTS[#...]"))
		return false;
	if (lexer_peek(lexer) == '<') {
		if (!linuxcnc_expr_name(lexer, name))
			return false;
		*value = system_param_names_has(name) || params_find(&linuxcnc_of(interp)->params, name);
	} else {
		if (!read_integer(expr, &number))
			return false;
		*value = number >= 1 && number < PARAM_NUMBERS;
	}
	return expect(lexer, ']', "after the parameter of EXISTS");
}

static bool read_arc_tangent(struct expr *expr, int column, double *value)
{
	struct expr_operand second;

	if (!expect(expr->lexer, '/', "after ATAN[...]") || !expr_bracket(expr, "ATAN[...]/", &second) ||
	    !linuxcnc_expr_sign_is_sure(expr->lexer->at, column, *value) ||
	    !linuxcnc_expr_sign_is_sure(expr->lexer->at, column, second.number))
		return false;
	*value = function_arc_tangent(*value, second.number);
	return true;
}

static bool compute_periodic(const struct line_place *at, int column, const struct function_name *function,
			     double *value)
{
	const double angle = *value;

	if (!function_compute(at, column, function, value))
		return false;
	if (is_zero(*value) && !is_zero(angle))
		*value = UNSURE_ZERO;
	return true;
}

/* Functions that are discontinuous at 0, or have no value below 0. */
static bool compute_abrupt(const struct line_place *at, int column, const struct function_name *function, double *value)
{
	switch (function->function) {
	case FUNCTION_FIX:
		*value = floor(*value);
		return true;
	case FUNCTION_FUP:
		*value = ceil(*value);
		return true;
	default:
		return function_compute(at, column, function, value);
	}
}

static bool read_function(struct expr *expr, int column, const struct function_name *function,
			  struct expr_operand *operand)
{
	const struct line_place *at = expr->lexer->at;
	double *value = &operand->number;

	if (function->function == FUNCTION_EXISTS)
		return read_exists(expr, value);
	if (!expr_bracket(expr, "the function", operand))
		return false;
	switch (function->function) {
	case FUNCTION_ATAN:
		return read_arc_tangent(expr, column, value);
	case FUNCTION_ROUND:
		return compute_round(at, column, value);
	case FUNCTION_SIN:
	case FUNCTION_COS:
	case FUNCTION_TAN:
		return compute_periodic(at, column, function, value);
	case FUNCTION_ABS:
	case FUNCTION_EXP:
	case FUNCTION_ACOS:
	case FUNCTION_ASIN:
		return function_compute(at, column, function, value);
	default:
		return linuxcnc_expr_sign_is_sure(at, column, *value) && compute_abrupt(at, column, function, value);
	}
}

/* ------------------------------------------------------------- parameters */

bool linuxcnc_expr_name(struct lexer *lexer, char *name)
{
	int column = lexer_column(lexer);
	size_t length = 0;
	char byte;

	for (lexer_take(lexer); (byte = lexer_peek(lexer)) != '>'; lexer_take(lexer)) {
		if (byte == '\0' || length == PARAM_NAME_MAX)
			return fault(lexer->at, column, "this parameter name is not closed: '>' is missing");
		name[length++] = ascii_lower(byte);
	}
	lexer_take(lexer);
	name[length] = '\0';
	return true;
}

static bool read_number_of_parameter(struct expr *expr, int *number)
{
	int column = lexer_next_column(expr->lexer);

	if (!expr_enter(expr) || !read_integer(expr, number))
		return false;
	expr->depth--;
	if (*number < 1 || *number >= PARAM_NUMBERS)
		return fault(expr->lexer->at, column, "#%d: parameters are numbered from 1 to %d", *number,
			     PARAM_NUMBERS - 1);
	return true;
}

static bool read_parameter(struct expr *expr, struct expr_operand *value)
{
	struct interp *interp = expr->context;
	int column = lexer_column(expr->lexer), number;
	char name[PARAM_NAME_MAX + 1];
	const struct named_param *param;

	lexer_take(expr->lexer);
	if (lexer_peek(expr->lexer) != '<')
		return read_number_of_parameter(expr, &number) &&
		       system_params_number(interp, number, column, &value->number);
	if (!linuxcnc_expr_name(expr->lexer, name))
		return false;
	if (system_param_names_has(name))
		return system_param_names_read(interp, name, column, &value->number);
	param = params_find(&linuxcnc_of(interp)->params, name);
	if (!param)
		return system_param_names_fault_unknown(interp, name, column);
	value->number = param->value;
	return true;
}

static const struct expr_rules rules = {
	.open = '[', .close = ']', .variable_starts = "#",
	.operators = operators, .operator_count = sizeof(operators) / sizeof(*operators),
	.functions = functions, .function_count = sizeof(functions) / sizeof(*functions),
	.signs_repeat = true, .depth_max = DEPTH_MAX, .nested = "values",
	.apply = apply, .function = read_function, .variable = read_parameter,
};

/* --------------------------------------------------------------- its users */

static struct expr expr_of(struct lexer *lexer)
{
	return (struct expr){.lexer = lexer, .rules = &rules, .context = lexer->context};
}

/* A value: -1.5, [1+2], #3, #<name>, SIN[30], -#3 */
static bool read_value(struct lexer *lexer, double *value)
{
	struct expr expr = expr_of(lexer);
	struct expr_operand operand;

	if (!expr_value(&expr, &operand))
		return false;
	*value = operand.number;
	return true;
}

bool linuxcnc_expr_bracket(struct lexer *lexer, const char *what, double *value)
{
	struct expr expr = expr_of(lexer);
	struct expr_operand operand;

	if (!expr_bracket(&expr, what, &operand))
		return false;
	*value = operand.number;
	return true;
}

bool linuxcnc_expr_integer(struct lexer *lexer, int *value)
{
	struct expr expr = expr_of(lexer);

	return read_integer(&expr, value);
}

static enum lexer_result read_word_value(struct lexer *lexer, struct word *word)
{
	if (!expr_follows(lexer, &rules))
		return LEXER_END;
	word->point = true;
	return read_value(lexer, &word->value) ? LEXER_WORD : LEXER_FAULT;
}

/* "#3=6": the value is remembered until the block has been read. */
static bool read_assignment(struct lexer *lexer)
{
	struct expr expr = expr_of(lexer);
	struct interp *interp = lexer->context;
	struct assignment new = {.column = lexer_column(lexer)};

	lexer_take(lexer);
	if (lexer_peek(lexer) == '<') {
		if (!linuxcnc_expr_name(lexer, new.name) ||
		    !system_param_names_check_write(interp, new.name, new.column))
			return false;
		/* From now on the parameter exists, with the value 0: this is how LinuxCNC reads "#<x>=[#<x>+1]". */
		if (!params_make(&linuxcnc_of(interp)->params, new.name))
			return fault(lexer->at, new.column, "more than %d named parameters", PARAM_NAMES_MAX);
	} else if (!read_number_of_parameter(&expr, &new.number) ||
		   !system_params_check_number(interp, new.number, new.column)) {
		return false;
	}
	if (!expect(lexer, '=', "after the parameter") || !read_value(lexer, &new.value))
		return false;
	*params_assign(&linuxcnc_of(interp)->params) = new;
	return true;
}

/* Comments that are commands (LinuxCNC's manual, "Comments"); messages and the log move nothing. */
static bool check_comment(const struct lexer *lexer, const char *text)
{
	if (ascii_same_start(text, "py,", 3))
		return fault(lexer->at, lexer_column(lexer), "a comment that runs Python code is not supported");
	if (ascii_same_start(text, "abort,", 6))
		return fault(lexer->at, lexer_column(lexer), "the comment (ABORT, ...) stops the program here");
	return true;
}

static const struct lexer_refusal refusals[] = {
	{'[', "an expression is allowed only after a letter or after '='"},
	{'$', "$: spindle numbers are not supported"},
};

const struct lexer_rules linuxcnc_lexer_rules = {
	.semicolon = SEMICOLON_STARTS_COMMENT,
	.polar_words = true,
	.value = read_word_value,
	.assignment_start = '#',
	.assignment = read_assignment,
	.check_comment = check_comment,
	.refusals = refusals,
	.refusal_count = sizeof(refusals) / sizeof(*refusals),
};
