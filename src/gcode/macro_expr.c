#include "gcode/macro_expr.h"

#include <math.h>
#include <string.h>

#include "gcode/expr_function.h"
#include "gcode/macro_vars.h"
#include "gcode/number.h"
#include "gcode/state.h"

/*
 * Controls compute with about nine digits (B-63944EN, "Operation error"): of
 * numbers that are nearer to each other, but not equal, nobody knows the order.
 */
#define NEAR 1e-8
#define LARGEST_WHOLE 2147483647.0

enum operation { NO_OPERATION, EQ, NE, GT, GE, LT, LE, PLUS, MINUS, OR, XOR, TIMES, DIVIDE, AND, MODULO };

struct operand {
	double number;	/* NAN: vacant */
	bool truth;	/* of a comparison: 1 or 0 */
};

/* What one pair of brackets has held so far. */
struct level {
	enum operation first;
};

static bool read_level(struct lexer *lexer, struct level *level, int rank, struct operand *value);

static bool is_fanuc(const struct lexer *lexer)
{
	return lexer->interp->config->dialect == GCODE_FANUC;
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

/* B-63944EN, "Priority of operations": functions; * / AND MOD; + - OR XOR; and comparisons last. */
static int rank_of(enum operation operation)
{
	return operation >= TIMES ? 3 : operation >= PLUS ? 2 : operation != NO_OPERATION ? 1 : 0;
}

static enum operation peek_operation(struct lexer *lexer)
{
	static const struct {
		const char *name;
		enum operation operation;
	} words[] = {{"eq", EQ}, {"ne", NE},   {"gt", GT},    {"ge", GE},     {"lt", LT},   {"le", LE},	   {"+", PLUS},
		     {"-", MINUS}, {"or", OR}, {"xor", XOR}, {"*", TIMES}, {"/", DIVIDE}, {"and", AND}, {"mod", MODULO}};
	size_t position = lexer->position;

	for (size_t i = 0; i < sizeof(words) / sizeof(*words); i++) {
		if (lexer_keyword(lexer, words[i].name)) {
			lexer->position = position;
			return words[i].operation;
		}
	}
	return NO_OPERATION;
}

static void take_operation(struct lexer *lexer, enum operation operation)
{
	size_t length = operation == PLUS || operation == MINUS || operation == TIMES || operation == DIVIDE ? 1
			: operation == AND || operation == MODULO || operation == XOR			     ? 3
													     : 2;

	for (; length > 0; length--) {
		lexer_peek(lexer);
		lexer_take(lexer);
	}
}

static bool is_logic(enum operation operation)
{
	return operation == AND || operation == OR || operation == XOR;
}

/* Haas's manual gives no order of AND, OR and XOR among the others. */
static bool check_order(struct lexer *lexer, struct level *level, enum operation operation, int column)
{
	if (level->first == NO_OPERATION)
		level->first = operation;
	if (is_fanuc(lexer) || operation == level->first || (!is_logic(operation) && !is_logic(level->first)))
		return true;
	return fault(lexer->at, column, "AND, OR and XOR among other operators: Haas gives no order; use brackets");
}

/* A vacant operand counts as 0 (B-63944EN, "Undefined variable"); what Haas makes of one is not in its manual. */
static bool fill(struct lexer *lexer, int column, struct operand *value)
{
	if (!isnan(value->number))
		return true;
	if (!is_fanuc(lexer))
		return fault(lexer->at, column, "a value is missing: a variable without one is computed with");
	value->number = 0;
	return true;
}

static bool same_order(double left, double right)
{
	double most = fmax(1, fmax(fabs(left), fabs(right))), difference = fabs(left - right);

	return difference > 0 && difference <= NEAR * most;
}

static bool holds(enum operation operation, double left, double right)
{
	switch (operation) {
	case EQ:
		return !(left < right) && !(left > right);
	case NE:
		return left < right || left > right;
	case GT:
		return left > right;
	case GE:
		return left >= right;
	case LT:
		return left < right;
	default:
		return left <= right;
	}
}

/* B-63944EN, "Undefined variable": in conditions a vacant value differs from 0 for EQ and NE only. */
static bool compare(struct lexer *lexer, int column, enum operation operation, struct operand *left,
		    struct operand *right)
{
	bool vacant = isnan(left->number), other = isnan(right->number);

	if (left->truth || right->truth)
		return fault(lexer->at, column, "the result of a comparison cannot be compared; use AND or OR");
	if ((operation == EQ || operation == NE) && (vacant || other) && (is_fanuc(lexer) || vacant == other)) {
		left->number = (vacant == other) == (operation == EQ);
		left->truth = true;
		return true;
	}
	/* A Haas program asks "#1 EQ #0" for a variable without a value; the number that #1 holds is not #0. */
	if ((operation == EQ || operation == NE) && other && !vacant) {
		*left = (struct operand){operation == NE, true};
		return true;
	}
	if (!fill(lexer, column, left) || !fill(lexer, column, right))
		return false;
	if (same_order(left->number, right->number))
		return fault(lexer->at, column,
			     "these numbers differ by %.2g only, less than a control computes with; compare with a margin",
			     fabs(left->number - right->number));
	*left = (struct operand){holds(operation, left->number, right->number), true};
	return true;
}

static bool is_whole(double value)
{
	return fabs(value) <= LARGEST_WHOLE && !(floor(value) < value);
}

/* Bit by bit (B-63944EN, "Logical operations"; Haas, "Logical operators": of the integer portion). */
static bool apply_logic(struct lexer *lexer, int column, enum operation operation, struct operand *left,
			struct operand *right)
{
	double numbers[2] = {left->number, right->number};
	unsigned long a, b;

	for (int i = 0; i < 2; i++) {
		if (!is_fanuc(lexer))
			numbers[i] = trunc(numbers[i]);
		if (numbers[i] < 0 || !is_whole(numbers[i]))
			return fault(lexer->at, column,
				     "AND, OR and XOR work on whole numbers that are not negative, not on %.15g",
				     numbers[i]);
	}
	if (is_fanuc(lexer) && left->truth != right->truth)
		return fault(lexer->at, column, "one of the operands is a comparison, and the other is none");
	a = (unsigned long)numbers[0];
	b = (unsigned long)numbers[1];
	left->number = (double)(operation == AND ? a & b : operation == OR ? a | b : a ^ b);
	left->truth = left->truth && right->truth;
	return true;
}

/* B-63944EN, "MOD": of whole numbers, with the sign of the first; other controls differ in both. */
static bool apply_modulo(struct lexer *lexer, int column, struct operand *left, double right)
{
	if (!is_whole(left->number) || !is_whole(right) || right < 0 || (left->number < 0 && !is_fanuc(lexer)))
		return fault(lexer->at, column, "MOD of %.15g and %.15g: controls agree on whole numbers only%s",
			     left->number, right, is_fanuc(lexer) ? "" : " that are not negative");
	left->number = fmod(left->number, right);
	return true;
}

static bool apply_arithmetic(struct lexer *lexer, int column, enum operation operation, struct operand *left,
			     struct operand *right)
{
	if (is_fanuc(lexer) && (left->truth || right->truth))
		return fault(lexer->at, column, "the result of a comparison is no number here");
	left->truth = false;
	if ((operation == DIVIDE || operation == MODULO) && fpclassify(right->number) == FP_ZERO)
		return fault(lexer->at, column, "division by zero");
	switch (operation) {
	case PLUS:
		left->number += right->number;
		break;
	case MINUS:
		left->number -= right->number;
		break;
	case TIMES:
		left->number *= right->number;
		break;
	case DIVIDE:
		left->number /= right->number;
		break;
	default:
		return apply_modulo(lexer, column, left, right->number);
	}
	if (isfinite(left->number))
		return true;
	return fault(lexer->at, column, "the result is infinite");
}

static bool apply(struct lexer *lexer, int column, enum operation operation, struct operand *left,
		  struct operand *right)
{
	if (rank_of(operation) == 1)
		return compare(lexer, column, operation, left, right);
	if (!fill(lexer, column, left) || !fill(lexer, column, right))
		return false;
	if (is_logic(operation))
		return apply_logic(lexer, column, operation, left, right);
	return apply_arithmetic(lexer, column, operation, left, right);
}

/* ------------------------------------------------------------------ values */

static bool read_brackets(struct lexer *lexer, const char *what, struct operand *value)
{
	struct level level = {NO_OPERATION};

	if (lexer_peek(lexer) != '[')
		return fault(lexer->at, lexer_column(lexer), "%s needs a value in brackets, [...]", what);
	if (lexer->depth >= MACRO_EXPR_DEPTH_MAX)
		return fault(lexer->at, lexer_column(lexer), "brackets are nested more than %d deep",
			     MACRO_EXPR_DEPTH_MAX);
	lexer->depth++;
	lexer_take(lexer);
	if (!read_level(lexer, &level, 1, value))
		return false;
	if (lexer_peek(lexer) != ']')
		return fault(lexer->at, lexer_column(lexer), "an operator or ']' is needed here");
	lexer_take(lexer);
	lexer->depth--;
	return true;
}

bool macro_expr_variable(struct lexer *lexer, int *number)
{
	int column = column_here(lexer);
	struct operand operand;
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
			return fault(lexer->at, column, "# needs the number of a variable, or an expression in brackets");
		lexer->position = position;
		break;
	}
	if (isnan(operand.number) || operand.number < 0 || !is_whole(operand.number))
		return fault(lexer->at, column, "# needs a whole number that is not negative");
	*number = (int)operand.number;
	return true;
}

/* FIX towards zero, FUP away from it (B-63944EN, "Rounding up and down to an integer"; Haas, "FIX": truncates). */
static bool compute_fix(struct lexer *lexer, int column, enum expr_function function, double *value)
{
	double nearest = round(*value);

	if (same_order(*value, nearest))
		return fault(lexer->at, column,
			     "%s of a number that differs from %.15g by %.2g only, less than a control computes with",
			     expr_function_name(function), nearest, fabs(*value - nearest));
	if (function == EXPR_FIX)
		*value = trunc(*value);
	else
		*value = *value < 0 ? floor(*value) : ceil(*value);
	return true;
}

/* To a whole number, or behind an address to its increment (B-63944EN, "ROUND function"; Haas, "ROUND"). */
static bool compute_round(struct lexer *lexer, int column, double *value)
{
	double scaled;

	if (lexer->macro == MACRO_ARGUMENTS)
		return fault(lexer->at, column, "ROUND in an argument: to which digit differs; assign it to a variable "
						"before");
	scaled = *value * lexer->steps;
	if (scaled < 0 && !(fabs(scaled - trunc(scaled)) < 0.5) && !(fabs(scaled - trunc(scaled)) > 0.5))
		return fault(lexer->at, column, "ROUND of %.15g: controls differ in the half of negative numbers", *value);
	*value = round(scaled) / lexer->steps;
	return true;
}

/*
 * B-63944EN, "ASIN", "ATAN", by parameter NAT (No. 6004#0), 0 as it comes:
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

/* ATAN[a]/[b] and ATAN[a,b] (Fanuc); ATAN[a] is that of a and 1. */
static bool read_arc_tangent(struct lexer *lexer, int column, struct operand *value)
{
	struct level level = {NO_OPERATION}, right = {NO_OPERATION};
	struct operand second = {1, false};
	bool pair = true;

	if (lexer_peek(lexer) != '[')
		return fault(lexer->at, lexer_column(lexer), "ATAN needs a value in brackets, [...]");
	lexer_take(lexer);
	if (!read_level(lexer, &level, 1, value))
		return false;
	if (lexer_peek(lexer) == ',' && is_fanuc(lexer)) {
		lexer_take(lexer);
		if (!read_level(lexer, &right, 1, &second))
			return false;
	} else {
		pair = false;
	}
	if (lexer_peek(lexer) != ']')
		return fault(lexer->at, lexer_column(lexer), "an operator or ']' is needed here");
	lexer_take(lexer);
	if (!pair && lexer_peek(lexer) == '/') {
		int slash = lexer_column(lexer);

		lexer_take(lexer);
		if (lexer_peek(lexer) != '[')
			return fault(lexer->at, slash, "ATAN[...]/ needs a value in brackets; to divide, write [ATAN[...]]/");
		if (!is_fanuc(lexer))
			return fault(lexer->at, slash,
				     "ATAN[...]/[...]: Haas's manual knows ATAN of one value; to divide, write [ATAN[...]]/");
		pair = true;
		if (!read_brackets(lexer, "ATAN[...]/", &second))
			return false;
	}
	if (!fill(lexer, column, value) || !fill(lexer, column, &second))
		return false;
	value->number = expr_function_arc_tangent(value->number, second.number);
	value->truth = false;
	if (pair)
		wrap_angle(lexer, column, &value->number);
	return true;
}

static bool read_function(struct lexer *lexer, struct operand *value)
{
	int column = column_here(lexer);
	enum expr_function function;

	if (!expr_function_read(lexer, &function) || function == EXPR_EXISTS)
		return fault(lexer->at, column, "a value is needed here");
	if (!is_fanuc(lexer) && (function == EXPR_FUP || function == EXPR_LN || function == EXPR_EXP))
		return fault(lexer->at, column, "Haas has no function %s", expr_function_name(function));
	if (function == EXPR_ATAN)
		return read_arc_tangent(lexer, column, value);
	if (!read_brackets(lexer, expr_function_name(function), value) || !fill(lexer, column, value))
		return false;
	if (is_fanuc(lexer) && value->truth)
		return fault(lexer->at, column, "the result of a comparison is no number here");
	value->truth = false;
	if (function == EXPR_FIX || function == EXPR_FUP)
		return compute_fix(lexer, column, function, &value->number);
	if (function == EXPR_ROUND)
		return compute_round(lexer, column, &value->number);
	if (!expr_function_compute(lexer, column, function, &value->number))
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

static bool read_operand(struct lexer *lexer, struct operand *value)
{
	char byte = lexer_peek(lexer);
	int column = lexer_column(lexer), number;

	*value = (struct operand){0, false};
	if (byte == '#')
		return macro_expr_variable(lexer, &number) &&
		       macro_vars_read(lexer->interp, number, column, &value->number);
	if (byte == '+' || byte == '-') {
		lexer_take(lexer);
		if (lexer_peek(lexer) == '+' || lexer_peek(lexer) == '-')
			return fault(lexer->at, lexer_column(lexer), "two signs");
		if (!read_operand(lexer, value) || !fill(lexer, column, value))
			return false;
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

static bool read_level(struct lexer *lexer, struct level *level, int rank, struct operand *value)
{
	enum operation operation;

	if (rank > 3)
		return read_operand(lexer, value);
	if (!read_level(lexer, level, rank + 1, value))
		return false;
	while (rank_of(operation = peek_operation(lexer)) == rank) {
		int column = column_here(lexer);
		struct operand right;

		if (!check_order(lexer, level, operation, column))
			return false;
		take_operation(lexer, operation);
		if (!read_level(lexer, level, rank + 1, &right) || !apply(lexer, column, operation, value, &right))
			return false;
	}
	return true;
}

/* --------------------------------------------------------------- its users */

bool macro_expr_follows(struct lexer *lexer)
{
	size_t position = lexer->position;
	enum expr_function function;
	bool follows;
	char byte;

	while ((byte = lexer_peek(lexer)) == '+' || byte == '-')
		lexer_take(lexer);
	follows = byte == '#' || byte == '[' || expr_function_read(lexer, &function);
	lexer->position = position;
	return follows;
}

/*
 * Steps of the address's least increment: IS-B where the machine file does not
 * say, 0.001 mm and degrees or 0.0001 inch (B-63944EN, "Variable reference";
 * Haas, "Address substitution"). 0: not rounded.
 */
static double steps_of(const struct lexer *lexer, char letter)
{
	const struct interp *interp = lexer->interp;
	double steps = interp->config->least_input > 0 ? round(1 / interp->config->least_input) : 1000;

	if (lexer->macro != MACRO_WORDS)
		return 0;
	if (letter >= 'A' && letter <= 'C')
		return steps;
	if (strchr("XYZUVWIJKQR", letter))
		return interp->state.scale > 1 ? steps * 10 : steps;
	return 0;
}

bool macro_expr_word(struct lexer *lexer, struct word *word)
{
	double steps = steps_of(lexer, word->letter);
	int column = column_here(lexer);
	struct operand value;
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

bool macro_expr_sum(struct lexer *lexer, double *value)
{
	struct level level = {NO_OPERATION};
	int column = column_here(lexer);
	struct operand operand;

	lexer->depth = 0;
	if (!read_level(lexer, &level, 1, &operand))
		return false;
	if (operand.truth && is_fanuc(lexer))
		return fault(lexer->at, column, "the result of a comparison is no number here");
	*value = operand.number;
	return true;
}

bool macro_expr_condition(struct lexer *lexer, const char *what, bool *is_true)
{
	int column = column_here(lexer);
	struct operand operand;

	lexer->depth = 0;
	if (!read_brackets(lexer, what, &operand))
		return false;
	if (is_fanuc(lexer) && !operand.truth)
		return fault(lexer->at, column, "%s needs a comparison: EQ, NE, GT, GE, LT or LE", what);
	if (!fill(lexer, column, &operand))
		return false;
	*is_true = fpclassify(operand.number) != FP_ZERO;
	return true;
}

bool macro_expr_integer(struct lexer *lexer, const char *what, int *value)
{
	int column = column_here(lexer);
	struct operand operand;

	lexer->depth = 0;
	if (!read_operand(lexer, &operand))
		return false;
	if (isnan(operand.number) || operand.number < 0 || !is_whole(operand.number))
		return fault(lexer->at, column, "%s must be a whole number that is not negative", what);
	*value = (int)operand.number;
	return true;
}
