#include "gcode/eval/expr.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "gcode/dialect/linuxcnc/params.h"
#include "gcode/dialect/linuxcnc/system_params.h"
#include "gcode/eval/function.h"
#include "gcode/state.h"
#include "gcode/text/number.h"

/* LinuxCNC's TOLERANCE_EQUAL: EQ and NE take such numbers for equal; up to version 2.9 it was coarser. */
#define EQUAL_TOLERANCE 1e-6
#define EQUAL_TOLERANCE_2_9 1e-4
/* Its tolerance for whole numbers. */
#define INTEGER_TOLERANCE 0.0001

enum operation {
	CLOSE, AND, XOR, OR, LT, EQ, NE, LE, GE, GT, MINUS, PLUS, DIVIDE, MODULO, TIMES, POWER
};

static bool is_digit(char byte)
{
	return byte >= '0' && byte <= '9';
}

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

/* -------------------------------------------------------------- operators */

static int precedence(enum operation operation)
{
	static const int levels[] = {[CLOSE] = 1, [AND] = 2,   [XOR] = 2,  [OR] = 2,	 [LT] = 3,     [EQ] = 3,
				     [NE] = 3,	  [LE] = 3,    [GE] = 3,   [GT] = 3,	 [MINUS] = 4,  [PLUS] = 4,
				     [DIVIDE] = 5, [MODULO] = 5, [TIMES] = 5, [POWER] = 6};

	return levels[operation];
}

static bool read_operation(struct lexer *lexer, enum operation *operation)
{
	static const struct {
		const char *name;
		enum operation operation;
	} words[] = {{"]", CLOSE}, {"+", PLUS}, {"-", MINUS},  {"/", DIVIDE}, {"**", POWER}, {"*", TIMES},
		     {"and", AND}, {"or", OR},	{"xor", XOR},  {"mod", MODULO}, {"eq", EQ},  {"ne", NE},
		     {"lt", LT},   {"le", LE},	{"gt", GT},    {"ge", GE}};
	char byte = lexer_peek(lexer);

	for (size_t i = 0; i < sizeof(words) / sizeof(*words); i++) {
		if (lexer_keyword(lexer, words[i].name)) {
			*operation = words[i].operation;
			return true;
		}
	}
	if (byte == '\0')
		return fault(lexer->at, lexer_column(lexer), "this expression is not closed: ']' is missing");
	return fault(lexer->at, lexer_column(lexer), "an operator or ']' is needed here");
}

static bool power(struct lexer *lexer, int column, double *left, double right)
{
	if (*left < 0 && (floor(right) < right || floor(right) > right))
		return fault(lexer->at, column, "a negative number to a power that is not whole");
	*left = pow(*left, right);
	return true;
}

static bool divide(struct lexer *lexer, int column, enum operation operation, double *left, double right)
{
	if (is_zero(right))
		return fault(lexer->at, column, "division by zero");
	if (operation == DIVIDE) {
		*left /= right;
		return true;
	}
	*left = fmod(*left, right);
	/* The result of MOD is never negative. */
	if (*left < 0)
		*left += fabs(right);
	return true;
}

/* LinuxCNC 2.9 compares exactly; later versions take nearly equal numbers for equal in LE and GE, too. */
static bool compare(struct lexer *lexer, int column, enum operation operation, double *left, double right)
{
	static const char *const names[] = {[EQ] = "EQ", [NE] = "NE", [LE] = "LE", [GE] = "GE"};
	double difference = fabs(*left - right);
	bool ordered = operation == LE || operation == GE, equal = difference < EQUAL_TOLERANCE;
	bool holds = operation == EQ   ? equal
		     : operation == NE ? !equal
		     : operation == LE ? *left <= right
				       : *left >= right;

	if (ordered ? !holds && equal : !equal && difference < EQUAL_TOLERANCE_2_9)
		return fault(lexer->at, column,
			     "%s of numbers that differ by %.2g only: versions of LinuxCNC disagree; compare with a "
			     "margin",
			     names[operation], difference);
	*left = holds;
	return true;
}

static bool apply(struct lexer *lexer, int column, enum operation operation, double *left, double right)
{
	switch (operation) {
	case POWER:
		return power(lexer, column, left, right);
	case DIVIDE:
	case MODULO:
		return divide(lexer, column, operation, left, right);
	case TIMES:
		*left *= right;
		return true;
	case PLUS:
		*left += right;
		return true;
	case MINUS:
		*left -= right;
		return true;
	case LT:
		*left = *left < right;
		return true;
	case GT:
		*left = *left > right;
		return true;
	case EQ:
	case NE:
	case LE:
	case GE:
		return compare(lexer, column, operation, left, right);
	case AND:
		*left = !is_zero(*left) && !is_zero(right);
		return true;
	case OR:
		*left = !is_zero(*left) || !is_zero(right);
		return true;
	case XOR:
		*left = is_zero(*left) != is_zero(right);
		return true;
	case CLOSE:
		break;
	}
	return false;	/* a closing bracket is never applied */
}

/* Operators whose right operand is not complete; their precedence rises, so six are the most. */
struct pending_operation {
	double left;
	enum operation operation;
	int column;
};

bool expr_bracket(struct lexer *lexer, const char *what, double *value)
{
	struct pending_operation stack[8];
	size_t count = 0;

	if (lexer_peek(lexer) != '[')
		return fault(lexer->at, lexer_column(lexer), "%s needs a value in brackets, [...]", what);
	lexer_take(lexer);
	for (;;) {
		enum operation operation = CLOSE;
		double right;
		int column;

		if (!expr_value(lexer, &right))
			return false;
		lexer_peek(lexer);
		column = lexer_column(lexer);
		if (!read_operation(lexer, &operation))
			return false;
		for (; count > 0 && precedence(operation) <= precedence(stack[count - 1].operation); count--) {
			struct pending_operation *top = &stack[count - 1];

			if (!apply(lexer, top->column, top->operation, &top->left, right))
				return false;
			right = top->left;
		}
		if (operation == CLOSE) {
			*value = right;
			return true;
		}
		assert(count < sizeof(stack) / sizeof(*stack));
		stack[count++] = (struct pending_operation){right, operation, column};
	}
}

/* -------------------------------------------------------------- functions */

/* LinuxCNC rounds by way of an int, halves away from zero. */
static bool compute_round(struct lexer *lexer, int column, double *value)
{
	double moved = *value + (*value < 0 ? -0.5 : 0.5);

	if (fabs(moved) >= 2147483648.0)
		return fault(lexer->at, column, "ROUND of %.15g: LinuxCNC rounds numbers below 2^31 only", *value);
	*value = trunc(moved);
	return true;
}

static bool compute(struct lexer *lexer, int column, enum expr_function function, double *value)
{
	switch (function) {
	case EXPR_FIX:
		*value = floor(*value);
		return true;
	case EXPR_FUP:
		*value = ceil(*value);
		return true;
	case EXPR_ROUND:
		return compute_round(lexer, column, value);
	default:
		return function_compute(lexer, column, function, value);
	}
}

/* EXISTS[#<name>]; a number exists if it is one of a parameter. */
static bool read_exists(struct lexer *lexer, double *value)
{
	char name[PARAM_NAME_MAX + 1];
	int number;

	if (!expect(lexer, '[', "after EXISTS") || !expect(lexer, '#', "in EXISTS[#...]"))
		return false;
	if (lexer_peek(lexer) == '<') {
		if (!expr_name(lexer, name))
			return false;
		*value = system_params_name_exists(name) || params_find(&lexer->interp->params, name);
	} else {
		if (!expr_integer(lexer, &number))
			return false;
		*value = number >= 1 && number < PARAM_NUMBERS;
	}
	return expect(lexer, ']', "after the parameter of EXISTS");
}

static bool read_function(struct lexer *lexer, double *value)
{
	int column = lexer_column(lexer);
	enum expr_function function;
	double second;

	if (!function_read(lexer, &function))
		return fault(lexer->at, column, "a value is needed here");
	if (function == EXPR_EXISTS)
		return read_exists(lexer, value);
	if (!expr_bracket(lexer, "the function", value))
		return false;
	if (function != EXPR_ATAN)
		return compute(lexer, column, function, value);
	if (!expect(lexer, '/', "after ATAN[...]") || !expr_bracket(lexer, "ATAN[...]/", &second))
		return false;
	*value = function_arc_tangent(*value, second);
	return true;
}

/* ----------------------------------------------------------------- values */

bool expr_follows(struct lexer *lexer)
{
	size_t position = lexer->position;
	bool sign = false, follows;
	enum expr_function function;
	char byte;

	for (; (byte = lexer_peek(lexer)) == '+' || byte == '-'; sign = true)
		lexer_take(lexer);
	follows = byte == '#' || byte == '[' || (sign && (is_digit(byte) || byte == '.'));
	follows = follows || function_read(lexer, &function);
	lexer->position = position;
	return follows;
}

bool expr_integer(struct lexer *lexer, int *value)
{
	double number, low;
	int column;

	lexer_peek(lexer);
	column = lexer_column(lexer);
	if (!expr_value(lexer, &number))
		return false;
	low = floor(number);
	if (number - low > 1 - INTEGER_TOLERANCE)
		low++;
	else if (number - low > INTEGER_TOLERANCE)
		return fault(lexer->at, column, "a whole number is needed here, not %.15g", number);
	if (fabs(low) > 2147483647.0)
		return fault(lexer->at, column, "%.15g is too large here", number);
	*value = (int)low;
	return true;
}

bool expr_name(struct lexer *lexer, char *name)
{
	int column = lexer_column(lexer);
	size_t length = 0;
	char byte;

	for (lexer_take(lexer); (byte = lexer_peek(lexer)) != '>'; lexer_take(lexer)) {
		if (byte == '\0' || length == PARAM_NAME_MAX)
			return fault(lexer->at, column, "this name is not closed: '>' is missing");
		name[length++] = byte >= 'A' && byte <= 'Z' ? (char)(byte - 'A' + 'a') : byte;
	}
	lexer_take(lexer);
	name[length] = '\0';
	return true;
}

static bool read_number_of_parameter(struct lexer *lexer, int *number)
{
	int column;

	lexer_peek(lexer);
	column = lexer_column(lexer);
	if (!expr_integer(lexer, number))
		return false;
	if (*number < 1 || *number >= PARAM_NUMBERS)
		return fault(lexer->at, column, "#%d: parameters are numbered from 1 to %d", *number,
			     PARAM_NUMBERS - 1);
	return true;
}

static bool read_parameter(struct lexer *lexer, double *value)
{
	int column = lexer_column(lexer), number;
	char name[PARAM_NAME_MAX + 1];
	const struct named_param *param;

	lexer_take(lexer);
	if (lexer_peek(lexer) != '<')
		return read_number_of_parameter(lexer, &number) &&
		       system_params_number(lexer->interp, number, column, value);
	if (!expr_name(lexer, name))
		return false;
	if (system_params_name_exists(name))
		return system_params_name(lexer->interp, name, column, value);
	param = params_find(&lexer->interp->params, name);
	if (!param)
		return system_params_fault_unknown(lexer->interp, name, column);
	*value = param->value;
	return true;
}

static bool read_plain_number(struct lexer *lexer, double *value)
{
	size_t position = lexer->position;
	bool point;

	switch (number_read(lexer->at->text, &position, value, &point)) {
	case NUMBER_OK:
		lexer->position = position;
		return true;
	case NUMBER_TOO_LONG:
		return fault(lexer->at, lexer_column(lexer), "a number of more than %d digits", NUMBER_LENGTH_MAX);
	case NUMBER_MISSING:
		break;
	}
	return fault(lexer->at, lexer_column(lexer), "a value is needed here");
}

static bool read_signed(struct lexer *lexer, char sign, double *value)
{
	size_t position = lexer->position;
	char next;

	lexer_take(lexer);
	next = lexer_peek(lexer);
	if (is_digit(next) || next == '.' || next == '\0') {
		lexer->position = position;
		return read_plain_number(lexer, value);
	}
	if (!expr_value(lexer, value))
		return false;
	if (sign == '-')
		*value = -*value;
	return true;
}

static bool read_value(struct lexer *lexer, double *value)
{
	char byte = lexer_peek(lexer);

	if (byte == '[')
		return expr_bracket(lexer, "this", value);
	if (byte == '#')
		return read_parameter(lexer, value);
	if (byte == '+' || byte == '-')
		return read_signed(lexer, byte, value);
	if (is_digit(byte) || byte == '.')
		return read_plain_number(lexer, value);
	return read_function(lexer, value);
}

bool expr_value(struct lexer *lexer, double *value)
{
	int column;

	lexer_peek(lexer);
	column = lexer_column(lexer);
	if (lexer->depth >= EXPR_DEPTH_MAX)
		return fault(lexer->at, column, "values are nested more than %d deep", EXPR_DEPTH_MAX);
	lexer->depth++;
	if (!read_value(lexer, value))
		return false;
	lexer->depth--;
	if (isfinite(*value))
		return true;
	return fault(lexer->at, column, "the result is %s", isnan(*value) ? "not a number" : "infinite");
}

bool expr_assignment(struct lexer *lexer)
{
	struct interp *interp = lexer->interp;
	struct assignment new = {.column = lexer_column(lexer)};

	lexer_take(lexer);
	if (lexer_peek(lexer) == '<') {
		if (!expr_name(lexer, new.name) || !system_params_check_name(interp, new.name, new.column))
			return false;
		/* From here on it exists, with the value 0: so does LinuxCNC read "#<x>=[#<x>+1]". */
		if (!params_make(&interp->params, new.name))
			return fault(lexer->at, new.column, "more than %d named parameters", PARAM_NAMES_MAX);
	} else if (!read_number_of_parameter(lexer, &new.number) ||
		   !system_params_check_number(interp, new.number, new.column)) {
		return false;
	}
	if (!expect(lexer, '=', "after the parameter") || !expr_value(lexer, &new.value))
		return false;
	*params_assign(&interp->params) = new;
	return true;
}
