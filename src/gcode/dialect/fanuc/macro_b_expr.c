#include "gcode/dialect/fanuc/macro_b_expr.h"

#include <math.h>
#include <string.h>

#include "gcode/dialect/fanuc/macro_b_operators.h"
#include "gcode/dialect/fanuc/macro_b_vars.h"
#include "gcode/eval/function.h"
#include "gcode/state.h"
#include "gcode/text/number.h"

/* What one pair of brackets has held so far. */
struct level {
	enum macro_b_operation first;
};

static bool read_level(struct lexer *lexer, struct level *level, int rank, struct macro_b_operand *value);

static bool is_fanuc(const struct lexer *lexer)
{
	return lexer->interp->config->dialect->legacy == GCODE_FANUC;
}

static bool is_digit(char byte)
{
	return byte >= '0' && byte <= '9';
}

static int column_here(struct lexer *lexer)
{
	lexer_peek(lexer);
	return lexer_column(lexer);
}

/* -------------------------------------------------------------- operations */

static const struct {
	const char *name;
	enum macro_b_operation operation;
} operations[] = {{"eq", MACRO_EQ},    {"ne", MACRO_NE},  {"gt", MACRO_GT},	{"ge", MACRO_GE},   {"lt", MACRO_LT},
		  {"le", MACRO_LE},    {"+", MACRO_PLUS}, {"-", MACRO_MINUS},	{"or", MACRO_OR},   {"xor", MACRO_XOR},
		  {"*", MACRO_TIMES}, {"/", MACRO_DIVIDE}, {"and", MACRO_AND}, {"mod", MACRO_MODULO}};

/* The operator that comes next, which is taken if its rank is this one. */
static enum macro_b_operation take_operation(struct lexer *lexer, int rank)
{
	size_t position = lexer->position;

	for (size_t i = 0; i < sizeof(operations) / sizeof(*operations); i++) {
		if (macro_b_operation_rank(operations[i].operation) != rank ||
		    !lexer_keyword(lexer, operations[i].name))
			continue;
		return operations[i].operation;
	}
	lexer->position = position;
	return MACRO_NO_OPERATION;
}

/* Haas's manual gives no order of AND, OR and XOR among the others. */
static bool check_order(struct lexer *lexer, struct level *level, enum macro_b_operation operation, int column)
{
	if (level->first == MACRO_NO_OPERATION)
		level->first = operation;
	if (is_fanuc(lexer) || operation == level->first ||
	    (!macro_b_operation_is_logic(operation) && !macro_b_operation_is_logic(level->first)))
		return true;
	return fault(lexer->at, column, "AND, OR and XOR among other operators: Haas gives no order; use brackets");
}

/* ------------------------------------------------------------------ values */

static bool open_bracket(struct lexer *lexer, const char *what)
{
	if (lexer_peek(lexer) != '[')
		return fault(lexer->at, lexer_column(lexer), "%s needs a value in brackets, [...]", what);
	if (lexer->depth >= MACRO_EXPR_DEPTH_MAX)
		return fault(lexer->at, lexer_column(lexer), "brackets are nested more than %d deep",
			     MACRO_EXPR_DEPTH_MAX);
	lexer->depth++;
	lexer_take(lexer);
	return true;
}

static bool close_bracket(struct lexer *lexer)
{
	if (lexer_peek(lexer) != ']')
		return fault(lexer->at, lexer_column(lexer), "an operator or ']' is needed here");
	lexer_take(lexer);
	lexer->depth--;
	return true;
}

static bool read_brackets(struct lexer *lexer, const char *what, struct macro_b_operand *value)
{
	struct level level = {MACRO_NO_OPERATION};

	return open_bracket(lexer, what) && read_level(lexer, &level, 1, value) && close_bracket(lexer);
}

bool macro_b_expr_variable(struct lexer *lexer, int *number)
{
	int column = column_here(lexer);
	struct macro_b_operand operand;
	size_t position;
	bool point;

	lexer_take(lexer);
	switch (lexer_peek(lexer)) {
	case '[':
		if (!read_brackets(lexer, "#", &operand))
			return false;
		break;
	case '#':
		return fault(lexer->at, column, "## is not allowed; write #[#...]");
	case '<':
		return fault(lexer->at, column, "variables with names are not supported yet");
	default:
		position = lexer->position;
		if (!is_digit(lexer_peek(lexer)) ||
		    number_read(lexer->at->text, &position, &operand.number, &point) != NUMBER_OK || point)
			return fault(lexer->at, column, "# needs the number of a variable, or an expression in "
							"brackets");
		lexer->position = position;
		break;
	}
	if (isnan(operand.number) || operand.number < 0 || !macro_b_is_whole(operand.number))
		return fault(lexer->at, column, "# needs a whole number that is not negative");
	*number = (int)operand.number;
	return true;
}

/* FIX towards zero, FUP away from it (B-63944EN, rounding up and down to an integer; Haas, FIX: truncates). */
static bool compute_fix(struct lexer *lexer, int column, enum expr_function function, double *value)
{
	double nearest = round(*value);

	if (macro_b_nearly_equal(*value, nearest))
		return fault(lexer->at, column,
			     "%s of a number that differs from %.15g by %.2g only, less than a control computes with",
			     function_name(function), nearest, fabs(*value - nearest));
	if (function == EXPR_FIX)
		*value = trunc(*value);
	else
		*value = *value < 0 ? floor(*value) : ceil(*value);
	return true;
}

/* To a whole number, or behind an address to its increment (B-63944EN, ROUND function; Haas, ROUND). */
static bool compute_round(struct lexer *lexer, int column, double *value)
{
	double scaled;

	if (lexer->macro == MACRO_ARGUMENTS)
		return fault(lexer->at, column, "ROUND in an argument: to which digit differs; assign it to a variable "
						"before");
	scaled = *value * lexer->steps;
	if (scaled < 0 && !(fabs(scaled - trunc(scaled)) < 0.5) && !(fabs(scaled - trunc(scaled)) > 0.5))
		return fault(lexer->at, column, "ROUND of %.15g: controls differ in the half of negative numbers",
			     *value);
	*value = round(scaled) / lexer->steps;
	return true;
}

/*
 * B-63944EN, ASIN, ATAN, by parameter NAT (No. 6004#0), 0 as it comes:
 * angles of 0 to 360, and 270 to 90, where they are -180 to 180 and -90 to 90 with 1.
 */
static void wrap_angle(struct lexer *lexer, int column, double *value)
{
	if (!is_fanuc(lexer) || !(*value < 0))
		return;
	if (!lexer->interp->macro.cautioned_angle)
		caution(lexer->at, column,
			"an angle of %.9g degrees, or %.9g with parameter 6004#0 (NAT) at 1: it is taken to be 0, here "
			"and further on",
			*value + 360, *value);
	lexer->interp->macro.cautioned_angle = true;
	*value += 360;
}

/* Behind ATAN[...]: "/[b]" of Fanuc, *given. */
static bool read_divisor(struct lexer *lexer, struct macro_b_operand *second, bool *given)
{
	int column;

	if (lexer_peek(lexer) != '/')
		return true;
	column = lexer_column(lexer);
	lexer_take(lexer);
	if (lexer_peek(lexer) != '[')
		return fault(lexer->at, column,
			     "ATAN[...]/ needs a value in brackets; to divide, write [ATAN[...]]/");
	if (!is_fanuc(lexer))
		return fault(lexer->at, column,
			     "ATAN[...]/[...]: Haas's manual knows ATAN of one value; to divide, write "
			     "[ATAN[...]]/");
	*given = true;
	return read_brackets(lexer, "ATAN[...]/", second);
}

/* ATAN[a]/[b] and ATAN[a,b] (Fanuc); ATAN[a] is that of a and 1. */
static bool read_arc_tangent(struct lexer *lexer, int column, struct macro_b_operand *value)
{
	struct level level = {MACRO_NO_OPERATION}, other = {MACRO_NO_OPERATION};
	struct macro_b_operand second = {1, false};
	bool pair;

	if (!open_bracket(lexer, "ATAN") || !read_level(lexer, &level, 1, value))
		return false;
	pair = lexer_peek(lexer) == ',' && is_fanuc(lexer);
	if (pair) {
		lexer_take(lexer);
		if (!read_level(lexer, &other, 1, &second))
			return false;
	}
	if (!close_bracket(lexer) || (!pair && !read_divisor(lexer, &second, &pair)))
		return false;
	if (!macro_b_operand_fill(lexer, column, value) || !macro_b_operand_fill(lexer, column, &second))
		return false;
	value->number = function_arc_tangent(value->number, second.number);
	value->truth = false;
	if (pair)
		wrap_angle(lexer, column, &value->number);
	return true;
}

/* Fanuc: two letters will do (B-63944EN, abbreviation). */
static bool read_function_name(struct lexer *lexer, enum expr_function *function)
{
	size_t position = lexer->position;

	if (function_read(lexer, function))
		return *function != EXPR_EXISTS;
	for (int i = 0; i < EXPR_FUNCTIONS && is_fanuc(lexer); i++) {
		const char *name = function_name((enum expr_function)i);
		char two[3] = {(char)(name[0] - 'A' + 'a'), (char)(name[1] - 'A' + 'a'), '\0'};

		if (i != EXPR_EXISTS && lexer_keyword(lexer, two) && lexer_peek(lexer) == '[') {
			*function = (enum expr_function)i;
			return true;
		}
		lexer->position = position;
	}
	return false;
}

static bool read_function(struct lexer *lexer, struct macro_b_operand *value)
{
	int column = column_here(lexer);
	enum expr_function function;

	if (!read_function_name(lexer, &function))
		return fault(lexer->at, column, "a value is needed here");
	if (!is_fanuc(lexer) && (function == EXPR_FUP || function == EXPR_LN || function == EXPR_EXP))
		return fault(lexer->at, column, "Haas has no function %s", function_name(function));
	if (function == EXPR_ATAN)
		return read_arc_tangent(lexer, column, value);
	if (!read_brackets(lexer, function_name(function), value) || !macro_b_operand_fill(lexer, column, value))
		return false;
	if (is_fanuc(lexer) && value->truth)
		return fault(lexer->at, column, "the result of a comparison is no number here");
	value->truth = false;
	if (function == EXPR_FIX || function == EXPR_FUP)
		return compute_fix(lexer, column, function, &value->number);
	if (function == EXPR_ROUND)
		return compute_round(lexer, column, &value->number);
	if (!function_compute(lexer, column, function, &value->number))
		return false;
	if (function == EXPR_ASIN)
		wrap_angle(lexer, column, &value->number);
	if (isfinite(value->number))
		return true;
	return fault(lexer->at, column, "the result is infinite");
}

static bool read_number(struct lexer *lexer, double *value)
{
	size_t position = lexer->position;
	bool point;

	if (number_read(lexer->at->text, &position, value, &point) != NUMBER_OK)
		return fault(lexer->at, column_here(lexer), "a value is needed here");
	lexer->position = position;
	return true;
}

static bool read_operand(struct lexer *lexer, struct macro_b_operand *value)
{
	char byte = lexer_peek(lexer);
	int column = lexer_column(lexer), number;

	*value = (struct macro_b_operand){0, false};
	if (byte == '#')
		return macro_b_expr_variable(lexer, &number) &&
		       macro_b_vars_read(lexer->interp, number, column, &value->number);
	if (byte == '+' || byte == '-') {
		lexer_take(lexer);
		if (lexer_peek(lexer) == '+' || lexer_peek(lexer) == '-')
			return fault(lexer->at, lexer_column(lexer), "two signs");
		if (!read_operand(lexer, value))
			return false;
		/* Of "X-#1" it is not said whether the word is left out, as of "X#1", or is X0. */
		if (isnan(value->number))
			return fault(lexer->at, column, "a sign before a variable without a value: whether that is 0 "
							"or nothing differs");
		value->number = byte == '-' ? -value->number : value->number;
		return true;
	}
	if (is_digit(byte) || byte == '.')
		return read_number(lexer, &value->number);
	if (byte != '[')
		return read_function(lexer, value);
	if (!read_brackets(lexer, "this", value))
		return false;
	if (isnan(value->number))
		return fault(lexer->at, column, "a variable without a value alone in brackets; leave the brackets out");
	return true;
}

static bool read_level(struct lexer *lexer, struct level *level, int rank, struct macro_b_operand *value)
{
	if (rank > 3)
		return read_operand(lexer, value);
	if (!read_level(lexer, level, rank + 1, value))
		return false;
	for (;;) {
		int column = column_here(lexer);
		enum macro_b_operation operation = take_operation(lexer, rank);
		struct macro_b_operand right;

		if (operation == MACRO_NO_OPERATION)
			return true;
		if (!check_order(lexer, level, operation, column))
			return false;
		if (!read_level(lexer, level, rank + 1, &right) || !macro_b_operate(lexer, column, operation, value,
										  &right))
			return false;
	}
}

/* --------------------------------------------------------------- its users */

bool macro_b_expr_follows(struct lexer *lexer)
{
	size_t position = lexer->position;
	enum expr_function function;
	bool follows;
	char byte;

	while ((byte = lexer_peek(lexer)) == '+' || byte == '-')
		lexer_take(lexer);
	follows = byte == '#' || byte == '[' || function_read(lexer, &function);
	lexer->position = position;
	return follows;
}

/*
 * Steps of the address's least increment: IS-B where the machine file does not
 * say, 0.001 mm and degrees or 0.0001 inch (B-63944EN, variable reference;
 * Haas, address substitution). 0: not rounded.
 */
static double steps_of(const struct lexer *lexer, char letter)
{
	const struct interp *interp = lexer->interp;
	double steps = interp->config->controller.least_input > 0 ? round(1 / interp->config->controller.least_input) : 1000;

	if (lexer->macro != MACRO_WORDS)
		return 0;
	if (letter >= 'A' && letter <= 'C')
		return steps;
	if (strchr("XYZUVWIJKQR", letter))
		return interp->state.scale > 1 ? steps * 10 : steps;
	return 0;
}

bool macro_b_expr_word(struct lexer *lexer, struct word *word)
{
	double steps = steps_of(lexer, word->letter);
	int column = column_here(lexer);
	struct macro_b_operand value;
	char byte;

	byte = lexer->at->text[column - 1];
	if (byte != '#' && byte != '[' && byte != '-' && byte != '+')
		return fault(lexer->at, column, "a function behind an address needs brackets, %c[...]", word->letter);
	lexer->depth = 0;
	lexer->steps = steps > 0 ? steps : 1;
	if (!read_operand(lexer, &value))
		return false;
	lexer->steps = 1;
	if (value.truth && is_fanuc(lexer))
		return fault(lexer->at, column, "the result of a comparison is no number here");
	word->point = true;
	word->vacant = isnan(value.number);
	word->value = word->vacant ? 0 : steps > 0 ? round(value.number * steps) / steps : value.number;
	return true;
}

bool macro_b_expr_sum(struct lexer *lexer, double *value)
{
	struct level level = {MACRO_NO_OPERATION};
	int column = column_here(lexer);
	struct macro_b_operand operand;

	lexer->depth = 0;
	if (!read_level(lexer, &level, 1, &operand))
		return false;
	if (operand.truth && is_fanuc(lexer))
		return fault(lexer->at, column, "the result of a comparison is no number here");
	*value = operand.number;
	return true;
}

bool macro_b_expr_condition(struct lexer *lexer, const char *what, bool *is_true)
{
	int column = column_here(lexer);
	struct macro_b_operand operand;

	lexer->depth = 0;
	if (!read_brackets(lexer, what, &operand))
		return false;
	if (is_fanuc(lexer) && !operand.truth)
		return fault(lexer->at, column, "%s needs a comparison: EQ, NE, GT, GE, LT or LE", what);
	if (!macro_b_operand_fill(lexer, column, &operand))
		return false;
	*is_true = fpclassify(operand.number) != FP_ZERO;
	return true;
}

bool macro_b_expr_integer(struct lexer *lexer, const char *what, int *value)
{
	int column = column_here(lexer);
	struct macro_b_operand operand;

	lexer->depth = 0;
	if (!read_operand(lexer, &operand))
		return false;
	if (isnan(operand.number) || operand.number < 0 || !macro_b_is_whole(operand.number))
		return fault(lexer->at, column, "%s must be a whole number that is not negative", what);
	*value = (int)operand.number;
	return true;
}
